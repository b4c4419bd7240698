// SPDX-License-Identifier: MIT
// Based on: Winter, "Biomechanics and Motor Control of Human Movement", 4th ed. 2009, table 4.1:
// masses of segments and where along them they are centred.
#pragma once

#include <Eigen/Core>
#include <map>
#include <numbers>
#include <string>

#include "core/motion/clip.h"
#include "resources/samples/generator/human_skeleton.h"

namespace mocapress::samples {

/// One instant of the figure: where the pelvis is and what angles the joints have.
struct Posture {
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  // cm, in the world
  std::map<std::string, Eigen::Vector3d> degrees;  // x y z of a joint; "root" is the pelvis

  /// Sets a joint of one side by the angles of the left one.
  void set(Side side, const std::string& bone, const Eigen::Vector3d& as_left) {
    degrees[sided(side, bone)] = mirrored_angles(side, as_left);
  }
};

/// The channels of a posture. Joints it does not mention are at zero.
Eigen::RowVectorXd channels_of(const Skeleton& skeleton, const Posture& posture);

/// The pelvis in the world: turned about x, then y, then z, as the root's channels are.
Eigen::Matrix3d world_from_root(const Posture& posture);

/// cm, in the world.
Eigen::Vector3d centre_of_mass(const Skeleton& skeleton, const Eigen::RowVectorXd& frame);

constexpr double in_degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}
constexpr double in_radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

}  // namespace mocapress::samples
