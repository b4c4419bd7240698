// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/batch/report.h"
#include "core/report/sign_off.h"

namespace mocapress {

/// The sign-off of a batch: each clip with its figures, and with the verdict and notes that it
/// brought from a project. Paths that are relative count from the current folder.
SignOff sign_off_of(const BatchRows& rows, const std::string& title);

}  // namespace mocapress
