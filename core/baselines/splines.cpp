// SPDX-License-Identifier: MIT
// Based on: C. de Boor, "A Practical Guide to Splines", 1978, chapter IV.

#include "core/baselines/splines.h"

#include <Eigen/Cholesky>
#include <cassert>
#include <vector>

namespace mocapress {

namespace {

/// Returns the spline's second derivative at each key, which is zero at both ends. Solves a
/// tridiagonal system by elimination from left to right.
Eigen::VectorXd second_derivatives(std::span<const int> frames, const Eigen::VectorXd& values) {
  const auto gap = [&](Eigen::Index i) { return static_cast<double>(frames[i + 1] - frames[i]); };
  const Eigen::Index keys = values.size();
  Eigen::VectorXd second = Eigen::VectorXd::Zero(keys);
  Eigen::VectorXd upper = Eigen::VectorXd::Zero(keys);
  for (Eigen::Index i = 1; i + 1 < keys; ++i) {
    const double slope_change =
        (values(i + 1) - values(i)) / gap(i) - (values(i) - values(i - 1)) / gap(i - 1);
    const double diagonal = 2 * (gap(i - 1) + gap(i)) - gap(i - 1) * upper(i - 1);
    upper(i) = gap(i) / diagonal;
    second(i) = (6 * slope_change - gap(i - 1) * second(i - 1)) / diagonal;
  }
  for (Eigen::Index i = keys - 2; i > 0; --i) second(i) -= upper(i) * second(i + 1);
  return second;
}

}  // namespace

Eigen::VectorXd natural_spline(std::span<const int> frames,
                               const Eigen::Ref<const Eigen::VectorXd>& values) {
  assert(!frames.empty() && static_cast<Eigen::Index>(frames.size()) == values.size());
  const Eigen::VectorXd second = second_derivatives(frames, values);
  Eigen::VectorXd curve(frames.back() - frames.front() + 1);
  curve(0) = values(0);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const auto key = static_cast<Eigen::Index>(i);
    const double gap = frames[i + 1] - frames[i];
    for (int t = frames[i] + 1; t <= frames[i + 1]; ++t) {
      const double b = (t - frames[i]) / gap;
      const double a = 1 - b;
      curve(t - frames.front()) =
          a * values(key) + b * values(key + 1) +
          ((a * a * a - a) * second(key) + (b * b * b - b) * second(key + 1)) * gap * gap / 6;
    }
  }
  return curve;
}

// Based on: G. Liu and L. McMillan, "Segment-Based Human Motion Compression", 2006, section on
// temporal coherence.

namespace {

std::vector<int> evenly_spaced(int frames) {
  std::vector<int> keys;
  for (int t = 0; t + 1 < frames; t += kMostKeyGap) keys.push_back(t);
  if (frames > 0) keys.push_back(frames - 1);
  return keys;
}

}  // namespace

std::vector<int> choose_key_frames(const Eigen::Ref<const Eigen::VectorXd>& curve,
                                   double tolerance) {
  std::vector<int> keys = evenly_spaced(static_cast<int>(curve.size()));
  for (bool grown = true; grown;) {
    const Eigen::VectorXd error = (natural_spline(keys, curve(keys)) - curve).cwiseAbs();
    std::vector<int> more{keys.front()};
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
      Eigen::Index worst = 0;
      if (error.segment(keys[i], keys[i + 1] - keys[i]).maxCoeff(&worst) > tolerance && worst > 0)
        more.push_back(keys[i] + static_cast<int>(worst));
      more.push_back(keys[i + 1]);
    }
    grown = more.size() > keys.size();
    keys = std::move(more);
  }
  return keys;
}

namespace {

/// The cubic Bernstein polynomials at i / steps for i = 1 to `steps`: steps x 4.
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
  // Regularises the fit: control points that the frames do not determine lie on a straight line.
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
