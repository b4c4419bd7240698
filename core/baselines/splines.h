// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace mocapress {

/// The natural cubic spline through `values` at ascending `frames`, at every frame from the first
/// to the last.
Eigen::VectorXd natural_spline(std::span<const int> frames,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

/// The largest distance between two key frames.
inline constexpr int kMostKeyGap = 255;

/// Frames, the first and last among them, through which a natural cubic spline keeps within
/// `tolerance` of the curve. They are added one by one at the largest error.
std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance);

/// Control points 1, 2 and 3 of cubic Bezier curves, one for each column, that start at the first
/// row (control point 0), end at the last and come nearest to those between.
Eigen::MatrixXd fit_bezier(const Eigen::Ref<const Eigen::MatrixXd>& rows);

/// Points of the curves at `steps` even steps after their start; the last row is control point 3.
Eigen::MatrixXd bezier_curve(const Eigen::RowVectorXd& start, const Eigen::MatrixXd& controls,
                             Eigen::Index steps);

}  // namespace mocapress
