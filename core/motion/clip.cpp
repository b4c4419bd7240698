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

Motion with_up_axis(const Motion& motion, UpAxis from, UpAxis to) {
  if (from == to) return motion;
  // Y and Z change places, and one of them changes its sign.
  const double y_as_z = from == UpAxis::Z ? -1 : 1;
  Eigen::Matrix3d to_from;
  to_from << 1, 0, 0, 0, 0, -y_as_z, 0, y_as_z, 0;
  Motion turned{{}, motion.clip};
  for (Joint joint : motion.skeleton.joints()) {
    joint.offset = to_from * joint.offset;
    joint.joint_from_axes = to_from * joint.joint_from_axes * to_from.transpose();
    if (joint.end_site) *joint.end_site = to_from * *joint.end_site;
    for (ChannelKind& kind : joint.channels)
      if (const int axis = axis_of(kind); axis > 0)
        kind = is_rotation(kind) ? rotation_about(3 - axis) : translation_about(3 - axis);
    turned.skeleton.add(std::move(joint));
  }
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    if (const int axis = axis_of(motion.skeleton.channel_kind(c)); axis > 0)
      turned.clip.channels.col(c) *= axis == 1 ? y_as_z : -y_as_z;
  return turned;
}

std::vector<bool> still_channels(const Clip& clip) {
  constexpr double kRounding = 1e-6;
  std::vector<bool> still;
  for (const auto& channel : clip.channels.colwise())
    still.push_back(channel.size() == 0 || channel.maxCoeff() - channel.minCoeff() <= kRounding);
  return still;
}

Motion frames_of(const Motion& motion, int first, int count) {
  return {motion.skeleton,
          {motion.clip.sample_rate_hz, motion.clip.channels.middleRows(first, count)}};
}

}  // namespace mocapress
