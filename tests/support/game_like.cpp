// SPDX-License-Identifier: MIT
#include "tests/support/game_like.h"

#include <cmath>
#include <numbers>

#include "core/motion/forward_kinematics.h"

namespace mocapress::test {
namespace {

constexpr int kChannels = 6;  // for each joint

Skeleton rig_of(const Skeleton& source) {
  using enum ChannelKind;
  const std::vector<ChannelKind> channels = {TranslationX, TranslationY, TranslationZ,
                                             RotationZ,    RotationX,    RotationY};
  Skeleton rig;
  rig.add({.name = "root_on_floor", .channels = channels});
  for (const Joint& joint : source.joints()) {
    Joint made{.name = joint.name, .parent = joint.parent + 1, .channels = channels};
    if (joint.parent >= 0) made.offset = joint.offset;
    if (joint.end_site) made.end_site = Eigen::Vector3d::Zero();
    rig.add(std::move(made));
  }
  return rig;
}

Eigen::Vector3d translation_of(const Joint& joint, const Eigen::RowVectorXd& values) {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  for (std::size_t c = 0; c < joint.channels.size(); ++c)
    if (!is_rotation(joint.channels[c]))
      translation(axis_of(joint.channels[c])) += values(static_cast<Eigen::Index>(c));
  return translation;
}

/// The heading that is nearest to the one before.
double heading_of(const Eigen::Matrix3d& rotation, double before) {
  const double heading = std::atan2(-rotation(2, 0), rotation(0, 0));
  return before + std::remainder(heading - before, 2 * std::numbers::pi);
}

}  // namespace

Motion game_like(const Motion& motion) {
  const Skeleton& source = motion.skeleton;
  Motion made{rig_of(source), {motion.clip.sample_rate_hz, {}}};
  Eigen::MatrixXd& to = made.clip.channels;
  to.setZero(motion.clip.frames(), made.skeleton.channel_count());
  for (int t = 0; t < motion.clip.frames(); ++t) {
    const int before = std::max(t - 1, 0);
    for (int j = 0; j < source.joint_count(); ++j) {
      const Joint& joint = source.joint(j);
      const Eigen::RowVectorXd values =
          motion.clip.channels.row(t).segment(source.first_channel(j), std::ssize(joint.channels));
      Eigen::Matrix3d parent_from_joint =
          joint.joint_from_axes * joint_rotation(joint, values) * joint.joint_from_axes.transpose();
      Eigen::Vector3d translation = translation_of(joint, values);
      const Eigen::Index first = kChannels * (j + 1);
      if (j == 0) {
        const Eigen::Vector3d hips = joint.offset + translation;  // in world space
        const double heading = heading_of(parent_from_joint, to(before, 5));
        to(t, 0) = hips.x();
        to(t, 2) = hips.z();
        to(t, 5) = heading;
        translation = Eigen::Vector3d(0, hips.y(), 0);
        parent_from_joint = axis_rotation(1, -heading) * parent_from_joint;
      }
      to.row(t).segment<3>(first) = translation;
      const Eigen::Vector3d angles_before = to.row(before).segment<3>(first + 3);
      to.row(t).segment<3>(first + 3) =
          three_angles({2, 0, 1}, parent_from_joint, angles_before).transpose();
    }
  }
  return made;
}

}  // namespace mocapress::test
