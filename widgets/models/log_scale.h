// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// Rounds a positive value to three significant digits.
inline double in_three_digits(double value) {
  const double exponent = std::floor(std::log10(value)) - 2;
  // Powers of ten below 1 are not exact doubles: dividing by their exact inverse adds no error.
  return exponent < 0 ? std::round(value * std::pow(10.0, -exponent)) / std::pow(10.0, -exponent)
                      : std::round(value / std::pow(10.0, exponent)) * std::pow(10.0, exponent);
}

/// Maps slider positions 0..steps to lowest..highest in equal factors: 2 to 4 takes as much room as
/// 100 to 200.
struct LogScale {
  double lowest = 1;
  double highest = 10;
  int steps = 1000;

  double value(int position) const {
    return lowest * std::pow(highest / lowest, static_cast<double>(position) / steps);
  }

  /// The number chosen by a slider position, rounded to three digits for people.
  double chosen(int position) const { return in_three_digits(value(position)); }

  /// The position for a value when the slider stands at `here`. It stays there if that position
  /// already means the value, since neighbours may round to the same three digits.
  int position(double value, int here) const {
    return chosen(here) == value ? here : position(value);
  }

  /// The nearest position to a value.
  int position(double value) const {
    const double share = std::log(value / lowest) / std::log(highest / lowest);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
  }
};

}  // namespace mocapress
