// SPDX-License-Identifier: MIT
#include "core/formats/zyx_angles.h"

#include <cmath>
#include <numbers>

namespace mocapress {
namespace {

constexpr double kPi = std::numbers::pi;

/// The angles plus whole turns, as near to `previous` as they get.
Eigen::Vector3d unwrapped(const Eigen::Vector3d& angles, const Eigen::Vector3d& previous) {
  return angles - 2 * kPi * ((angles - previous) / (2 * kPi)).array().round().matrix();
}

/// The rotation a joint's channels make, about its parent's axes.
Eigen::Matrix3d parent_from_joint(const Joint& joint, const Eigen::RowVectorXd& values) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < joint.channels.size(); ++i)
    if (is_rotation(joint.channels[i]))
      rotation *= axis_rotation(axis_of(joint.channels[i]), values(static_cast<Eigen::Index>(i)));
  return joint.joint_from_axes * rotation * joint.joint_from_axes.transpose();
}

/// Translations first, then rz ry rx where the joint turns at all.
Joint turned_about_parent_axes(Joint joint) {
  joint.joint_from_axes.setIdentity();
  const auto removed = std::erase_if(joint.channels, is_rotation);
  if (removed > 0)
    joint.channels.insert(joint.channels.end(),
                          {ChannelKind::RotationZ, ChannelKind::RotationY, ChannelKind::RotationX});
  return joint;
}

/// `from` holds the channels of `joint`, `to` those of its turned_about_parent_axes().
void convert_channels(const Joint& joint, const Eigen::MatrixXd& from,
                      Eigen::Ref<Eigen::MatrixXd> to) {
  Eigen::Index translations = 0;
  for (std::size_t i = 0; i < joint.channels.size(); ++i)
    if (!is_rotation(joint.channels[i]))
      to.col(translations++) = from.col(static_cast<Eigen::Index>(i));
  if (translations == to.cols()) return;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();
  for (Eigen::Index t = 0; t < from.rows(); ++t) {
    angles = zyx_angles(parent_from_joint(joint, from.row(t)), angles);
    to.block<1, 3>(t, translations) = angles.reverse().transpose();
  }
}

}  // namespace

Eigen::Vector3d zyx_angles(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& previous) {
  constexpr double kGimbalLock = 1e-9;
  const double r00 = rotation(0, 0);
  const double r10 = rotation(1, 0);
  const double z = std::hypot(r00, r10) > kGimbalLock ? std::atan2(r10, r00) : previous.z();
  const Eigen::Matrix3d y_and_x = axis_rotation(2, z).transpose() * rotation;
  const double y = std::atan2(-y_and_x(2, 0), y_and_x(0, 0));
  const double x = std::atan2(-y_and_x(1, 2), y_and_x(1, 1));
  const Eigen::Vector3d first = unwrapped({x, y, z}, previous);
  const Eigen::Vector3d second = unwrapped({x + kPi, kPi - y, z + kPi}, previous);
  return (first - previous).norm() <= (second - previous).norm() ? first : second;
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
