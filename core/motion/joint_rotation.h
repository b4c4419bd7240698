// SPDX-License-Identifier: MIT
// Rotations of a joint as one matrix, whatever its channels.
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The product R of a joint's rotation channels, about its own axes (Joint). `values`: one for each
/// of `joint.channels`.
Eigen::Matrix3d joint_rotation(const Joint& joint, const Eigen::RowVectorXd& values);

/// Sets the rotation channels among `values` so that joint_rotation() comes as near to `rotation`
/// as the joint can: exactly with three different axes. `values` holds the frame before, from which
/// angles go on without jumps.
void turn_joint(const Joint& joint, const Eigen::Matrix3d& rotation, Eigen::RowVectorXd& values);

/// Angles with rotation = R_i(a) R_j(b) R_k(c) about three different axes (0 1 2: x y z): of both
/// solutions the one nearer to `previous`.
Eigen::Vector3d three_angles(const std::array<int, 3>& axes, const Eigen::Matrix3d& rotation,
                             const Eigen::Vector3d& previous);

/// Whether the joint turns at all.
bool turns(const Joint& joint);

}  // namespace mocapress
