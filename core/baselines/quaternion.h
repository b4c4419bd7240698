// SPDX-License-Identifier: MIT
#pragma once

#include "core/baselines/comparison_method.h"

namespace mocapress {

/// Adaptive wavelets on quaternions in place of angles; a detail is a number of coefficients.
const ComparisonMethod& quaternion_method();

}  // namespace mocapress
