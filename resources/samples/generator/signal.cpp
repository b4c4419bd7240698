// SPDX-License-Identifier: MIT
#include "resources/samples/generator/signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mocapress::samples {

Signal::Signal(double first_second, double last_second, const std::function<double(double)>& value)
    : first_second_(first_second),
      samples_(static_cast<Eigen::Index>(std::ceil((last_second - first_second) * kRate)) + 1) {
  for (Eigen::Index i = 0; i < samples_.size(); ++i)
    samples_(i) = value(first_second + static_cast<double>(i) / kRate);
}

double Signal::at(double seconds) const {
  const double last = static_cast<double>(samples_.size() - 1);
  const double position = std::clamp((seconds - first_second_) * kRate, 0.0, last);
  const auto before = std::min(static_cast<Eigen::Index>(position), samples_.size() - 2);
  const double share = position - static_cast<double>(before);
  return (1 - share) * samples_(before) + share * samples_(before + 1);
}

Eigen::VectorXd Signal::around(Eigen::Index sample, int half) const {
  Eigen::VectorXd window(2 * half + 1);
  for (Eigen::Index i = -half; i <= half; ++i)
    window(half + i) = samples_(std::clamp<Eigen::Index>(sample + i, 0, samples_.size() - 1));
  return window;
}

Signal Signal::smoothed(double reach) const {
  const int half = half_width(reach);
  Eigen::VectorXd weights(2 * half + 1);
  for (int i = -half; i <= half; ++i)
    weights(half + i) = 1 + std::cos(std::numbers::pi * i / (half + 1));
  weights /= weights.sum();
  Signal smooth = *this;
  for (Eigen::Index i = 0; i < samples_.size(); ++i)
    smooth.samples_(i) = weights.dot(around(i, half));
  return smooth;
}

Signal Signal::lowered(double reach) const {
  const int half = half_width(reach);
  Signal low = *this;
  for (Eigen::Index i = 0; i < samples_.size(); ++i) low.samples_(i) = around(i, half).minCoeff();
  return low;
}

}  // namespace mocapress::samples
