// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace mocapress {

/// Returns the natural cubic spline through `values` at ascending `frames`, at every frame from the
/// first to the last.
Eigen::VectorXd natural_spline(std::span<const int> frames,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

/// The most frames from one key frame to the next.
inline constexpr int kMostKeyGap = 255;

/// Chooses key frames, among them the first and last, so that a natural cubic spline through them
/// stays within `tolerance` of the curve. Adds key frames where the error is largest.
std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance);

/// Fits a cubic Bezier curve to each column. Its control point 0 is the first row and its control
/// point 3 the last row; points 1 and 2 are those that come nearest to the rows between (least
/// squares). Returns points 1, 2 and 3.
Eigen::MatrixXd fit_bezier(const Eigen::Ref<const Eigen::MatrixXd>& rows);

/// Returns points of the curves at `steps` even steps after the start. The last row is control
/// point 3.
Eigen::MatrixXd bezier_curve(const Eigen::RowVectorXd& start, const Eigen::MatrixXd& controls,
                             Eigen::Index steps);

}  // namespace mocapress
