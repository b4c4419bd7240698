// SPDX-License-Identifier: MIT
#include "core/motion/forward_kinematics.h"

#include <cassert>
#include <cmath>

namespace mocapress {
namespace {

/// rotation *= axis_rotation(axis, radians), which mixes but two columns.
void turn(Eigen::Matrix3d& rotation, int axis, double radians) {
  const double cosine = std::cos(radians);
  const double sine = std::sin(radians);
  const int j = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  const Eigen::Vector3d before = rotation.col(j);
  rotation.col(j) = cosine * before + sine * rotation.col(k);
  rotation.col(k) = cosine * rotation.col(k) - sine * before;
}

/// Gathers a joint's channels into a translation (cm, parent's frame) and the product R (axes).
struct LocalMotion {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  LocalMotion(const Joint& joint, int first_channel, const FrameRow& frame) {
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      const ChannelKind kind = joint.channels[i];
      const double value = frame(first_channel + static_cast<int>(i));
      if (is_rotation(kind))
        turn(rotation, axis_of(kind), value);
      else
        translation(axis_of(kind)) += value;
    }
  }
};

}  // namespace

void compute_pose(const Skeleton& skeleton, const FrameRow& frame, Pose& pose) {
  assert(frame.size() == skeleton.channel_count());
  const auto count = static_cast<std::size_t>(skeleton.joint_count());
  pose.world_from_joint.resize(count);
  pose.origin.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const Joint& joint = skeleton.joints()[j];
    const LocalMotion local(joint, skeleton.first_channel(static_cast<int>(j)), frame);
    const Eigen::Vector3d in_parent = joint.offset + local.translation;
    const Eigen::Matrix3d parent_from_joint =
        joint.parent_from_axes() * local.rotation * joint.axes_from_joint();
    if (joint.parent < 0) {
      pose.origin[j] = in_parent;
      pose.world_from_joint[j] = parent_from_joint;
    } else {
      const auto parent = static_cast<std::size_t>(joint.parent);
      pose.origin[j] = pose.to_world(joint.parent, in_parent);
      pose.world_from_joint[j] = pose.world_from_joint[parent] * parent_from_joint;
    }
  }
}

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  for (const Joint& joint : skeleton.joints()) {
    pose.world_from_joint.push_back(Eigen::Matrix3d::Identity());
    pose.origin.push_back(joint.offset);
    if (joint.parent >= 0) pose.origin.back() += pose.origin[static_cast<std::size_t>(joint.parent)];
  }
  return pose;
}

}  // namespace mocapress
