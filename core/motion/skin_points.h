// SPDX-License-Identifier: MIT
// A character's surface as it is measured: points spread evenly over its mesh, moved as engines
// move them.
#pragma once

#include <array>
#include <vector>

#include "core/motion/landmarks.h"
#include "core/motion/skin.h"

namespace mocapress {

/// Points of the mesh, each for as much of its area as the others, in the pose it was bound in. The
/// same for the same mesh. Empty for a mesh without area.
SkinPoints points_on(const Skin& skin);

/// From now on Weighting::Skin measures this skin on the skeleton's joints. Null, or without area:
/// none.
void measure_on(const Skin* skin, Skeleton& skeleton);

/// A squared error of all points, as one of points that are fixed to joints, which is what an
/// ErrorModel takes. Each share of a point stands alone there: where joints that carry a point move
/// apart, its error is overrated, as the square of a mean is less than the mean of squares. What
/// one joint carries alone is exact. Four points a joint, with the mean and the second moments of
/// its shares.
MeasuredPoints carried_points(const SkinPoints& skin, const Skeleton& skeleton);

/// Corners of the box around what each joint carries for a good part: where none of them is far
/// off, no point between them is.
std::vector<Landmark> corners_of(const SkinPoints& skin, const Skeleton& skeleton);

/// What one joint carries of the mesh, as four points with its mean and second moments.
struct CarriedMesh {
  int joint;
  double share;                             // of all points
  std::array<Eigen::Vector3d, 4> in_joint;  // cm
};

/// Of each joint that carries some, in their order.
std::vector<CarriedMesh> carried_meshes(const SkinPoints& skin);

}  // namespace mocapress
