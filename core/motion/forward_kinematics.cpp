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

}  // namespace

void compute_pose(const Skeleton& skeleton, const FrameRow& frame, Pose& pose) {
  assert(frame.size() == skeleton.channel_count());
  const auto count = static_cast<std::size_t>(skeleton.joint_count());
  pose.world_from_joint.resize(count);
  pose.origin.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const Joint& joint = skeleton.joints()[j];
    const JointAxes& axes = skeleton.axes(static_cast<int>(j));
    const auto parent = static_cast<std::size_t>(joint.parent);
    const bool is_root = joint.parent < 0;
    Eigen::Matrix3d& world_from_joint = pose.world_from_joint[j];
    if (joint.channels.empty() && !is_root) {
      world_from_joint = pose.world_from_joint[parent];
      pose.origin[j] = pose.to_world(joint.parent, joint.offset);
      continue;
    }
    if (is_root)
      world_from_joint = axes.parent_from_axes;
    else
      world_from_joint.noalias() = pose.world_from_joint[parent] * axes.parent_from_axes;
    Eigen::Vector3d in_parent = joint.offset;
    const int first_channel = skeleton.first_channel(static_cast<int>(j));
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      const ChannelKind kind = joint.channels[i];
      const double value = frame(first_channel + static_cast<int>(i));
      if (is_rotation(kind))
        turn(world_from_joint, axis_of(kind), value);
      else
        in_parent(axis_of(kind)) += value;
    }
    pose.origin[j] = is_root ? in_parent : pose.to_world(joint.parent, in_parent);
    world_from_joint = world_from_joint * axes.axes_from_joint;
  }
}

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  for (const Joint& joint : skeleton.joints()) {
    pose.world_from_joint.push_back(Eigen::Matrix3d::Identity());
    pose.origin.push_back(joint.offset);
    if (joint.parent >= 0)
      pose.origin.back() += pose.origin[static_cast<std::size_t>(joint.parent)];
  }
  return pose;
}

}  // namespace mocapress
