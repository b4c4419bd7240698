// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

#include "core/motion/clip.h"

namespace mocapress {

/// The solution (x, y, z) in radians of rotation = Rz * Ry * Rx that is nearest to `previous`.
Eigen::Vector3d zyx_angles(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& previous);

/// The same motion, in which each joint that `wanted` selects turns about its parent's axes: its
/// joint_from_axes is identity and its rotation channels are rz ry rx, continuous over time.
Motion with_zyx_angles(const Motion& motion, const std::function<bool(const Joint&)>& wanted);

}  // namespace mocapress
