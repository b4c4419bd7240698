// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/motion/clip.h"
#include "core/motion/skeleton.h"

namespace mocapress {

// The rotation of a joint as one matrix, from any number of channels.

/// The product R of a joint's rotation channels, about its own axes (Joint). `values`: one for each
/// of `joint.channels`.
Eigen::Matrix3d joint_rotation(const Joint& joint, const Eigen::RowVectorXd& values);

/// Sets the rotation channels among `values` so that joint_rotation() comes as near to `rotation`
/// as the joint can. A joint with three different axes reaches it exactly. `values` holds the frame
/// before: angles continue from there without jumps.
void turn_joint(const Joint& joint, const Eigen::Matrix3d& rotation, Eigen::RowVectorXd& values);

/// Angles with rotation = R_i(a) R_j(b) R_k(c) about three different axes (0 1 2: x y z). Takes
/// the solution nearer to `previous`.
Eigen::Vector3d three_angles(const std::array<int, 3>& axes, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& previous);

/// True if the joint has a rotation channel.
bool turns(const Joint& joint);

/// One row of Clip::channels: a frame. Rows of a column-major matrix are strided.
using FrameRow = Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>;

/// The frame of every joint in the world: x_in_world = origin + world_from_joint * x_in_joint.
struct Pose {
  std::vector<Eigen::Matrix3d> world_from_joint;
  std::vector<Eigen::Vector3d> origin;  // cm, in the world

  Eigen::Vector3d to_world(int joint, const Eigen::Vector3d& in_joint) const {
    const auto j = static_cast<std::size_t>(joint);
    return origin[j] + world_from_joint[j] * in_joint;
  }
};

/// Forward kinematics of one frame. `pose` is resized; reuse it to avoid allocation.
void compute_pose(const Skeleton& skeleton, const FrameRow& frame, Pose& pose);

/// The pose with every channel at zero.
Pose rest_pose(const Skeleton& skeleton);

}  // namespace mocapress
