// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/log_scale.h"

#include <algorithm>
#include <cmath>

namespace mocapress {

double LogScale::value(int position) const {
  return lowest * std::pow(highest / lowest, static_cast<double>(position) / steps);
}

int LogScale::position(double value) const {
  const double share = std::log(value / lowest) / std::log(highest / lowest);
  return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
}

}  // namespace mocapress
