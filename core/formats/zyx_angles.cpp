// SPDX-License-Identifier: MIT
#include "core/formats/zyx_angles.h"

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

/// The joint with its translation channels first, then rz ry rx if it turns at all, and with
/// joint_from_axes identity.
Joint turned_about_parent_axes(Joint joint) {
  joint.joint_from_axes.setIdentity();
  const auto removed = std::erase_if(joint.channels, is_rotation);
  if (removed > 0)
    joint.channels.insert(joint.channels.end(),
                          {ChannelKind::RotationZ, ChannelKind::RotationY, ChannelKind::RotationX});
  return joint;
}

/// Converts the channels of `joint`, in `from`, to those of turned_about_parent_axes(), in `to`.
void convert_channels(const Joint& joint, const Eigen::MatrixXd& from,
                      Eigen::Ref<Eigen::MatrixXd> to) {
  Eigen::Index translations = 0;
  for (std::size_t i = 0; i < joint.channels.size(); ++i)
    if (!is_rotation(joint.channels[i])) to.col(translations++) = from.col(i);
  if (translations == to.cols()) return;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (Eigen::Index t = 0; t < from.rows(); ++t) {
    const Eigen::Matrix3d parent_from_joint = joint.joint_from_axes *
                                              joint_rotation(joint, from.row(t)) *
                                              joint.joint_from_axes.transpose();
    angles = zyx_angles(parent_from_joint, angles);
    to.block<1, 3>(t, translations) = angles.reverse().transpose();
  }
}

}  // namespace

Eigen::Vector3d zyx_angles(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& previous) {
  return three_angles({2, 1, 0}, rotation, previous.reverse()).reverse();
}

Motion with_zyx_angles(const Motion& motion, const std::function<bool(const Joint&)>& wanted) {
  Motion result;
  for (const Joint& joint : motion.skeleton.joints())
    result.skeleton.add(wanted(joint) ? turned_about_parent_axes(joint) : joint);
  result.clip.sample_rate_hz = motion.clip.sample_rate_hz;
  result.clip.channels.resize(motion.clip.frames(), result.skeleton.channel_count());
  for (int j = 0; j < result.skeleton.joint_count(); ++j) {
    const Joint& joint = motion.skeleton.joint(j);
    const Eigen::MatrixXd from = motion.clip.channels.middleCols(
        motion.skeleton.first_channel(j), static_cast<Eigen::Index>(joint.channels.size()));
    auto to = result.clip.channels.middleCols(
        result.skeleton.first_channel(j),
        static_cast<Eigen::Index>(result.skeleton.joint(j).channels.size()));
    if (wanted(joint))
      convert_channels(joint, from, to);
    else
      to = from;
  }
  return result;
}

}  // namespace mocapress
