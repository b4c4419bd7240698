// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/exaggeration.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/motion/forward_kinematics.h"

namespace mocapress {

Eigen::MatrixXd exaggerated(const Eigen::MatrixXd& original, const Eigen::MatrixXd& other,
                            double times) {
  return original + times * (other - original);
}

void exaggerate(const Pose& original, double times, Pose& pose) {
  for (std::size_t j = 0; j < pose.origin.size(); ++j) {
    pose.origin[j] = original.origin[j] + times * (pose.origin[j] - original.origin[j]);
    const Eigen::AngleAxisd difference(
        Eigen::Matrix3d(original.world_from_joint[j].transpose() * pose.world_from_joint[j]));
    // A joint can be turned by at most half a turn.
    const double angle = std::min(times * difference.angle(), std::numbers::pi);
    pose.world_from_joint[j] =
        original.world_from_joint[j] * Eigen::AngleAxisd(angle, difference.axis());
  }
}

std::function<void(int frame, Pose& pose)> exaggeratedPoses(
    const std::function<void(int frame, Pose& pose)>& original,
    const std::function<void(int frame, Pose& pose)>& other, double times) {
  if (!original || !other) return {};
  return [=](int frame, Pose& pose) {
    Pose before;
    original(frame, before);
    other(frame, pose);
    exaggerate(before, times, pose);
  };
}

}  // namespace mocapress
