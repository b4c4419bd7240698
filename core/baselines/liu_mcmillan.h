// SPDX-License-Identifier: MIT
#pragma once

#include "core/baselines/comparison_method.h"

namespace mocapress {

/// PCA of segments with key frames for each component; a detail is a tolerance.
const ComparisonMethod& liu_mcmillan_method();

}  // namespace mocapress
