// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// The nearest number of three significant digits; `value` is above 0.
inline double in_three_digits(double value) {
  const double exponent = std::floor(std::log10(value)) - 2;
  // Powers of ten below 1 have no exact double: divided by, they leave none of their error.
  return exponent < 0 ? std::round(value * std::pow(10.0, -exponent)) / std::pow(10.0, -exponent)
                      : std::round(value / std::pow(10.0, exponent)) * std::pow(10.0, exponent);
}

/// Slider positions 0..steps for values lowest..highest, equal factors apart: 2 to 4 takes as much
/// room as 100 to 200.
struct LogScale {
  double lowest = 1;
  double highest = 10;
  int steps = 1000;

  double value(int position) const {
    return lowest * std::pow(highest / lowest, static_cast<double>(position) / steps);
  }

  /// The number that a slider there chooses: in three digits, as people read it.
  double chosen(int position) const { return in_three_digits(value(position)); }

  /// Where a slider goes that stands `here`: it stays where that is chosen already, for in three
  /// digits neighbours may choose the same.
  int position(double value, int here) const {
    return chosen(here) == value ? here : position(value);
  }

  /// The nearest.
  int position(double value) const {
    const double share = std::log(value / lowest) / std::log(highest / lowest);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
  }
};

}  // namespace mocapress
