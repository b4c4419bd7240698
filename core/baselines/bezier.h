// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace mocapress {

/// Control points 1, 2 and 3 of the cubic Bezier curves, one a column, that start at the first row
/// (control point 0), end at the last and come nearest to those between.
Eigen::MatrixXd fit_bezier(const Eigen::Ref<const Eigen::MatrixXd>& rows);

/// The curves at `steps` even steps after their start: the last row is control point 3.
Eigen::MatrixXd bezier_curve(const Eigen::RowVectorXd& start, const Eigen::MatrixXd& controls,
                             Eigen::Index steps);

}  // namespace mocapress
