// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// One row of Clip::channels: a frame. Rows of a column-major matrix are strided.
using FrameRow = Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>;

/// Where every joint's frame is in the world: x_in_world = origin + world_from_joint * x_in_joint.
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
