// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace mocapress {

/// The natural cubic spline through `values` at rising `frames`, at every frame from the first of
/// them to the last.
Eigen::VectorXd natural_spline(std::span<const int> frames,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

/// No two key frames are further apart.
inline constexpr int kMostKeyGap = 255;

/// Frames, first and last among them, through which a natural cubic spline keeps within
/// `tolerance` of the curve: added where it is worst until it does.
std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance);

/// Control points 1, 2 and 3 of the cubic Bezier curves, one a column, that start at the first row
/// (control point 0), end at the last and come nearest to those between.
Eigen::MatrixXd fit_bezier(const Eigen::Ref<const Eigen::MatrixXd>& rows);

/// The curves at `steps` even steps after their start: the last row is control point 3.
Eigen::MatrixXd bezier_curve(const Eigen::RowVectorXd& start, const Eigen::MatrixXd& controls,
                             Eigen::Index steps);

}  // namespace mocapress
