// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mocapress {

/// Slider positions 0..steps for values lowest..highest, equal factors apart: 2 to 4 takes as much
/// room as 100 to 200.
struct LogScale {
  double lowest = 1;
  double highest = 10;
  int steps = 1000;

  double value(int position) const;
  int position(double value) const;  // the nearest
};

}  // namespace mocapress
