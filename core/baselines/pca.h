// SPDX-License-Identifier: MIT
#pragma once

#include "core/baselines/comparison_method.h"

namespace mocapress {

/// Principal component analysis of the poses without the root's position; a detail is the number
/// of components.
const ComparisonMethod& pca_method();

}  // namespace mocapress
