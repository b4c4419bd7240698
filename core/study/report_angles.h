// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/study/results.h"

namespace mocapress {

/// By how many degrees each clip's joints, head and hands are turned, by each series at one target:
/// the ratio nearest to that of the paper's video, else the error nearest to headline_eps_cm().
/// Empty where nothing was measured.
std::string angle_table(const Results& results);

}  // namespace mocapress
