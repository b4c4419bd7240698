// SPDX-License-Identifier: MIT
#include "core/baselines/bezier.h"

#include <Eigen/Cholesky>

namespace mocapress {
namespace {

/// Bernstein polynomials at even steps after 0: steps x 4.
Eigen::MatrixX4d bernstein(Eigen::Index steps) {
  Eigen::MatrixX4d weights(steps, 4);
  for (Eigen::Index i = 0; i < steps; ++i) {
    const double b = static_cast<double>(i + 1) / static_cast<double>(steps);
    const double a = 1 - b;
    weights.row(i) << a * a * a, 3 * a * a * b, 3 * a * b * b, b * b * b;
  }
  return weights;
}

}  // namespace

Eigen::MatrixXd fit_bezier(const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  // Where the frames between do not say, the control points are those of a straight line.
  constexpr double kStraight = 1e-9;
  const Eigen::Index steps = rows.rows() - 1;
  const Eigen::RowVectorXd start = rows.row(0);
  const Eigen::RowVectorXd end = rows.row(steps);
  Eigen::MatrixXd controls(3, rows.cols());
  controls << start + (end - start) / 3, end - (end - start) / 3, end;
  if (rows.cols() == 0) return controls;
  const Eigen::MatrixX2d inner = bernstein(steps).middleCols<2>(1);
  const Eigen::MatrixXd missed = rows.bottomRows(steps) - bezier_curve(start, controls, steps);
  const Eigen::Matrix2d normal =
      inner.transpose() * inner + kStraight * Eigen::Matrix2d::Identity();
  controls.topRows<2>() += normal.ldlt().solve(inner.transpose() * missed);
  return controls;
}

Eigen::MatrixXd bezier_curve(const Eigen::RowVectorXd& start, const Eigen::MatrixXd& controls,
                             Eigen::Index steps) {
  const Eigen::MatrixX4d weights = bernstein(steps);
  return weights.col(0) * start + weights.rightCols<3>() * controls;
}

}  // namespace mocapress
