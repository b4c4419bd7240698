// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// Rounds a positive value to three significant digits.
inline double in_three_digits(double value) {
  const double exponent = std::floor(std::log10(value)) - 2;
  // Negative powers of ten are not exact doubles. Dividing by the positive power, which is exact,
  // adds no error.
  return exponent < 0 ? std::round(value * std::pow(10.0, -exponent)) / std::pow(10.0, -exponent)
                      : std::round(value / std::pow(10.0, exponent)) * std::pow(10.0, exponent);
}

/// Maps slider positions 0..steps logarithmically to lowest..highest: 2 to 4 takes as much room as
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

  /// The slider position for a value. Stays at the present position `here` if that already means
  /// the value, since neighbouring positions may round to the same three digits.
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
