// SPDX-License-Identifier: MIT
// The methods that the wavelets are measured against. Their bytes: METHODS.md.
#pragma once

#include "core/codec/methods/comparison_method.h"

namespace mocapress {

/// Principal component analysis of the poses without the root's position; a detail is the number
/// of components.
const ComparisonMethod& pca_method();

/// Every s-th frame and the last, natural cubic splines between; a detail is a stride s.
const ComparisonMethod& subsample_method();

/// PCA of segments with key frames for each component; a detail is a tolerance.
const ComparisonMethod& liu_mcmillan_method();

/// For methods that split until a curve fits, the tolerance (cm) of a detail: 40 at detail 0.
inline constexpr int kMostDetail = 8000;
constexpr double tolerance_of_detail(int detail) {
  return 40.0 / (1 + detail);
}

/// Lets all rivals be found by name, in the order of the paper. A program that compares calls it
/// once, first of all.
void add_rivals();

}  // namespace mocapress
