// SPDX-License-Identifier: MIT
#include "core/motion/forward_kinematics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/runtime/format/kinematics.h"

namespace mocapress {

namespace {

/// The rotation channels of a joint and their angles.
struct Turns {
  std::vector<int> axes;
  std::vector<Eigen::Index> places;  // among the joint's channels
  Eigen::VectorXd angles;

  Turns(const Joint& joint, const Eigen::RowVectorXd& values) {
    for (std::size_t i = 0; i < joint.channels.size(); ++i)
      if (is_rotation(joint.channels[i])) {
        axes.push_back(axis_of(joint.channels[i]));
        places.push_back(static_cast<Eigen::Index>(i));
      }
    angles = values(places);
  }
  bool has_three_axes() const {
    return axes.size() == 3 && axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2];
  }
};

/// The angle of the turn about `axis` that is nearest to `rotation`.
double nearest_angle(int axis, const Eigen::Matrix3d& rotation) {
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  return std::atan2(rotation(c, b) - rotation(b, c), rotation(b, b) + rotation(c, c));
}

/// Solves one angle at a time while the others are held. Each step brings the product nearer to
/// `rotation`; with two axes, at right angles, a few rounds suffice.
void approach(Turns& turns, const Eigen::Matrix3d& rotation) {
  constexpr int kMostRounds = 32;
  constexpr double kSettled = 1e-10;
  const auto count = static_cast<Eigen::Index>(turns.axes.size());
  const auto turn = [&](Eigen::Index i) { return axis_rotation(turns.axes[i], turns.angles(i)); };
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd before = turns.angles;
    for (Eigen::Index i = 0; i < count; ++i) {
      Eigen::Matrix3d left = Eigen::Matrix3d::Identity();
      Eigen::Matrix3d right = Eigen::Matrix3d::Identity();
      for (Eigen::Index o = 0; o < i; ++o) left *= turn(o);
      for (Eigen::Index o = i + 1; o < count; ++o) right *= turn(o);
      turns.angles(i) =
          nearest_angle(turns.axes[i], left.transpose() * rotation * right.transpose());
    }
    for (Eigen::Index i = 0; i < count; ++i)
      turns.angles(i) = runtime::nearest_turn(turns.angles(i), before(i));
    if (count == 1 || (turns.angles - before).cwiseAbs().maxCoeff() < kSettled) break;
  }
}

}  // namespace

Eigen::Vector3d three_angles(const std::array<int, 3>& axes, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& previous) {
  return runtime::three_angles(axes, rotation, previous);
}

Eigen::Matrix3d joint_rotation(const Joint& joint, const Eigen::RowVectorXd& values) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  runtime::apply_channels(
      joint.channels.data(), static_cast<int>(joint.channels.size()),
      [&](int c) { return values(c); }, rotation, translation);
  return rotation;
}

void turn_joint(const Joint& joint, const Eigen::Matrix3d& rotation, Eigen::RowVectorXd& values) {
  Turns turns(joint, values);
  if (turns.axes.empty()) return;
  if (turns.has_three_axes())
    turns.angles =
        three_angles({turns.axes[0], turns.axes[1], turns.axes[2]}, rotation, turns.angles);
  else
    approach(turns, rotation);
  values(turns.places) = turns.angles.transpose();
}

bool turns(const Joint& joint) {
  return std::ranges::any_of(joint.channels, is_rotation);
}

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
    runtime::apply_channels(
        joint.channels.data(), static_cast<int>(joint.channels.size()),
        [&](int c) { return frame(first_channel + c); }, world_from_joint, in_parent);
    pose.origin[j] = is_root ? in_parent : pose.to_world(joint.parent, in_parent);
    world_from_joint = world_from_joint * axes.axes_from_joint;
  }
}

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  for (const Joint& joint : skeleton.joints()) {
    pose.world_from_joint.push_back(Eigen::Matrix3d::Identity());
    pose.origin.push_back(joint.offset);
    if (joint.parent >= 0) pose.origin.back() += pose.origin[joint.parent];
  }
  return pose;
}

}  // namespace mocapress
