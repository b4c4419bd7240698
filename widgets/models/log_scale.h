// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace mocapress {

/// Slider positions 0..steps for values lowest..highest, equal factors apart: 2 to 4 takes as much
/// room as 100 to 200.
struct LogScale {
  double lowest = 1;
  double highest = 10;
  int steps = 1000;

  double value(int position) const {
    return lowest * std::pow(highest / lowest, static_cast<double>(position) / steps);
  }

  /// The nearest.
  int position(double value) const {
    const double share = std::log(value / lowest) / std::log(highest / lowest);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
  }
};

}  // namespace mocapress
