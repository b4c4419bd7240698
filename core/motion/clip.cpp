// SPDX-License-Identifier: MIT
#include "core/motion/clip.h"

#include <cmath>
#include <numbers>

namespace mocapress {

void unwrap_angles(const Skeleton& skeleton, Clip& clip) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    if (!is_rotation(skeleton.channel_kind(c))) continue;
    auto angle = clip.channels.col(c);
    double turns = 0;
    double previous = angle.size() > 0 ? angle(0) : 0.0;
    for (Eigen::Index t = 1; t < angle.size(); ++t) {
      const double read = angle(t);
      turns -= std::round((read - previous) / kTurn);
      previous = read;
      angle(t) = read + turns * kTurn;
    }
  }
}

}  // namespace mocapress
