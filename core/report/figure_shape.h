// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// A tapered limb between two landmarks.
struct DrawnBone {
  int from;  // landmarks
  int to;
  double from_radius;  // cm
  double to_radius;
};

/// A body for a skeleton: limbs that taper as trees do, each as thick as all that it carries is
/// long (Leonardo's rule), and a head.
std::vector<DrawnBone> figure_shape(const Skeleton& skeleton);

/// Where the figure faces, horizontal and of length 1, from where its legs join the trunk. World z
/// when it has no legs to tell. `points` are the landmarks of one frame, y up.
Eigen::Vector3d facing(const Skeleton& skeleton, const std::vector<Eigen::Vector3d>& points);

}  // namespace mocapress
