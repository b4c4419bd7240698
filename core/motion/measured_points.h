// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

/// Points fixed to joints, and how much each counts. Weights sum to 1.
struct MeasuredPoints {
  std::vector<Landmark> points;
  Eigen::VectorXd weights;
};

inline constexpr double kShellRadius = 3;  // cm, as ACL has it for characters

/// What a weighting looks at. On bones: landmarks(), as landmark_weights() has them. On the
/// surface: four points for each stretch of the body, with the mean and the second moments of a
/// cylinder's surface, so that their error is that of all the skin there. On the shell: three for
/// each joint, along its axes.
MeasuredPoints measured_points(const Skeleton& skeleton, Weighting weighting);

/// Whether a weighting looks at landmarks() and nothing else.
constexpr bool is_on_bones(Weighting weighting) {
  return weighting == Weighting::BoneEnds || weighting == Weighting::JointOrigins;
}

/// Three points of each joint in turn, kShellRadius along its axes.
std::vector<Landmark> shell_points(const Skeleton& skeleton);

}  // namespace mocapress
