// SPDX-License-Identifier: MIT
// The methods that the wavelets are measured against. Their bytes: METHODS.md.
#pragma once

#include "core/codec/methods/comparison_method.h"

namespace mocapress {

/// Principal component analysis of poses without the root's position. A detail is the number of
/// components.
extern const ComparisonMethod kPca;

/// Every s-th frame and the last, with natural cubic splines between. A detail is a stride s.
extern const ComparisonMethod kSubsample;

/// Adaptive wavelets on quaternions in place of angles. A detail is a number of coefficients.
extern const ComparisonMethod kQuaternion;

/// PCA of segments, with key frames for each component. A detail is a tolerance.
extern const ComparisonMethod kLiuMcMillan;

/// Clustered PCA of short Bezier curves of virtual markers, with the clip alone as database. A
/// detail is a tolerance.
extern const ComparisonMethod kArikan;

/// Each channel by itself, with key frames and steps as fine as it needs: what engines do. A detail
/// is a tolerance.
extern const ComparisonMethod kKeyFrames;

/// The largest detail of methods that split until a curve fits, and the tolerance (cm) of a detail:
/// 40 at detail 0.
inline constexpr int kMostDetail = 8000;
constexpr double tolerance_of_detail(int detail) {
  return 40.0 / (1 + detail);
}

/// Registers all rivals by name, in the order of the paper. A program that compares methods calls
/// it once at its start.
void add_rivals();

}  // namespace mocapress
