// SPDX-License-Identifier: MIT
#pragma once

#include "core/baselines/comparison_method.h"

namespace mocapress {

/// Every s-th frame and the last, natural cubic splines between; a detail is a stride s.
const ComparisonMethod& subsample_method();

}  // namespace mocapress
