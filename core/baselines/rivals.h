// SPDX-License-Identifier: MIT
// The methods that the wavelets are compared with. METHODS.md defines their bytes. Each method has
// a "detail", an integer that sets how closely it follows the motion.
#pragma once

#include "core/codec/methods/comparison_method.h"

namespace mocapress {

/// Principal component analysis of poses without the root's position. The detail is the number of
/// components.
extern const ComparisonMethod kPca;

/// Keeps every s-th frame and the last, with natural cubic splines between. The detail counts
/// strides s, from the longest to 1.
extern const ComparisonMethod kSubsample;

/// Adaptive wavelets on quaternions in place of angles. The detail is the number of coefficients.
extern const ComparisonMethod kQuaternion;

/// PCA of segments, with key frames for each component. The detail stands for a tolerance.
extern const ComparisonMethod kLiuMcMillan;

/// Clustered PCA of short Bezier curves of virtual markers; the database is the clip alone. The
/// detail stands for a tolerance.
extern const ComparisonMethod kArikan;

/// Codes each channel by itself, as engines do: with key frames, and quantised only as finely as it
/// needs. The detail stands for a tolerance.
extern const ComparisonMethod kKeyFrames;

/// The largest detail of methods whose detail stands for a tolerance. The tolerance is 40 cm at
/// detail 0.
inline constexpr int kMostDetail = 8000;
constexpr double tolerance_of_detail(int detail) {
  return 40.0 / (1 + detail);
}

/// Registers all methods of this file by name, in the order of the paper. Programs that compare
/// methods call it once when they start.
void add_rivals();

}  // namespace mocapress
