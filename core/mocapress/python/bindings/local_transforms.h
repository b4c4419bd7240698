// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mocapress/motion.h"

namespace mocapress::python {

/// Frames x 4 * joints: w x y z of the unit quaternion parent_from_joint. Its sign never changes
/// from one frame to the next.
Eigen::MatrixXd local_rotations(const Motion& motion);

/// Frames x 3 * joints: the origin of each joint in its parent's frame, cm.
Eigen::MatrixXd local_translations(const Motion& motion);

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A motion as programs other than ours have it. Maps point into memory that outlives the call.
struct LocalTransforms {
  std::vector<std::string> names;
  std::vector<int> parents;                 // before their children; -1: a root
  Eigen::Map<const RowMajor> offsets;       // joints x 3, cm
  Eigen::Map<const RowMajor> rotations;     // frames x 4 * joints: w x y z, of any length but 0
  Eigen::Map<const RowMajor> translations;  // frames x 3 * joints; x 3: of joint 0; x 0: none
  std::map<int, Eigen::Vector3d> end_sites;
  double sample_rate_hz = 0;
};

/// The same motion in channels: each joint turns about Z, X and Y, in this order. Joint 0 moves,
/// and so does any other whose translation changes; the rest stay at their offsets. Throws
/// std::invalid_argument for what is no motion.
Motion motion_of(const LocalTransforms& transforms);

}  // namespace mocapress::python
