// SPDX-License-Identifier: MIT
// A character's surface as errors are measured on it: points spread evenly over its mesh, moved as
// engines move them.
#pragma once

#include <array>
#include <vector>

#include "core/motion/landmarks.h"
#include "core/motion/skin.h"

namespace mocapress {

/// Points on the mesh in its bind pose, each standing for the same area. Equal meshes give equal
/// points. Empty for a mesh without area.
SkinPoints points_on(const Skin& skin);

/// Makes Weighting::Skin measure this skin on the skeleton's joints. With null or a skin without
/// area, it measures nothing.
void measure_on(const Skin* skin, Skeleton& skeleton);

/// Points that are each fixed to one joint, as an ErrorModel takes them, and whose squared error
/// stands for that of all skin points. Each joint's share of a skin point counts by itself. This
/// overrates the error where joints that carry a point move apart, since the square of a mean is
/// less than the mean of squares; the error of points that one joint carries alone is exact. Each
/// joint has four points, with the mean and the second moments of its shares.
MeasuredPoints carried_points(const SkinPoints& skin, const Skeleton& skeleton);

/// For each joint, the corners of the box around the points that it mostly carries. If every corner
/// is near its original place, so is every point in the box.
std::vector<Landmark> corners_of(const SkinPoints& skin, const Skeleton& skeleton);

/// The part of a mesh that one joint carries, as four points with its mean and second moments.
struct CarriedMesh {
  int joint;
  double share;                             // share of all points
  std::array<Eigen::Vector3d, 4> in_joint;  // cm
};

/// The carried part of each joint that has one, in order of joints.
std::vector<CarriedMesh> carried_meshes(const SkinPoints& skin);

}  // namespace mocapress
