// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/batch/report.h"
#include "core/report/sign_off.h"

namespace mocapress {

/// Makes the sign-off of a batch: each clip with its measurements, and with the verdict and notes
/// that came with it from a project. Relative paths count from the current folder.
SignOff sign_off_of(const BatchRows& rows, const std::string& title);

}  // namespace mocapress
