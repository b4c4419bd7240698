// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/mocapress/motion.h"

namespace mocapress::python {

/// The unit quaternions parent_from_joint of all joints: frames x (4 * joints), each w x y z. Signs
/// are chosen so that a quaternion never flips from one frame to the next.
Eigen::MatrixXd local_rotations(const Motion& motion);

/// The origins of all joints in their parents' frames, in cm: frames x (3 * joints).
Eigen::MatrixXd local_translations(const Motion& motion);

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A motion in the form that other programs have. The maps must point into memory that outlives the
/// call.
struct LocalTransforms {
  std::vector<std::string> names;
  std::vector<int> parents;                 // a parent comes before its children; -1: a root
  Eigen::Map<const RowMajor> offsets;       // joints x 3, cm
  Eigen::Map<const RowMajor> rotations;     // frames x (4 * joints): w x y z, of any length but 0
  Eigen::Map<const RowMajor> translations;  // frames x (3 * joints); 3 columns: joint 0; 0: none
  std::map<int, Eigen::Vector3d> end_sites;
  double sample_rate_hz = 0;
};

/// Converts a motion to channels: each joint turns about Z, X and Y, in this order. Joint 0 has
/// translations, and so has any other joint whose translation changes; the rest stay at their
/// offsets. Throws std::invalid_argument if the transforms are not a motion.
Motion motion_of(const LocalTransforms& transforms);

}  // namespace mocapress::python
