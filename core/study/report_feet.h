// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/study/results.h"

namespace mocapress {

/// What holding the feet by IK does at one and the same size: error, footskate and the speed of the
/// knees, clip by clip. Empty where a study held none.
std::string held_feet_table(const Results& results);

}  // namespace mocapress
