// SPDX-License-Identifier: MIT
// Based on: C. de Boor, "A Practical Guide to Splines", 1978, chapter IV.
#include "core/baselines/cubic_spline.h"

#include <cassert>
#include <vector>

namespace mocapress {
namespace {

/// The second derivative at each key, zero at both ends: a tridiagonal system, solved by
/// elimination from left to right.
Eigen::VectorXd second_derivatives(std::span<const int> frames, const Eigen::VectorXd& values) {
  const auto gap = [&](Eigen::Index i) {
    return static_cast<double>(frames[static_cast<std::size_t>(i + 1)] -
                               frames[static_cast<std::size_t>(i)]);
  };
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

}  // namespace mocapress
