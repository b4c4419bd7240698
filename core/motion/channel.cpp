// SPDX-License-Identifier: MIT
#include "core/motion/channel.h"

#include <array>
#include <cmath>

namespace mocapress {

std::string_view short_name(ChannelKind kind) {
  constexpr std::array<std::string_view, kChannelKinds> kNames = {"tx", "ty", "tz",
                                                                  "rx", "ry", "rz"};
  return kNames[static_cast<std::size_t>(kind)];
}

Eigen::Matrix3d axis_rotation(int axis, double radians) {
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(next, next) = c;
  rotation(next, last) = -s;
  rotation(last, next) = s;
  rotation(last, last) = c;
  return rotation;
}

}  // namespace mocapress
