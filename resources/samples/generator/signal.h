// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

namespace mocapress::samples {

/// A function of time held as samples, so that it can be smoothed.
class Signal {
 public:
  Signal(double first_second, double last_second, const std::function<double(double)>& value);

  /// Linear between samples, constant outside.
  double at(double seconds) const;

  /// Weighted mean over a Hann window that ends `reach` (s) away on either side.
  Signal smoothed(double reach) const;

  /// The least value within `reach` (s) on either side: smoothed(reach) of it never exceeds this.
  Signal lowered(double reach) const;

 private:
  static constexpr double kRate = 120;  // Hz
  int half_width(double reach) const { return static_cast<int>(reach * kRate); }
  Eigen::VectorXd around(Eigen::Index sample, int half) const;

  double first_second_;
  Eigen::VectorXd samples_;
};

}  // namespace mocapress::samples
