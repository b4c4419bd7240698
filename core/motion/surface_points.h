// SPDX-License-Identifier: MIT
// The points that Weighting::Surface measures.
#pragma once

#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

/// Four points for each stretch of body_limbs(), with the mean and the second moments of a
/// cylinder's surface; shell_points() in a skeleton without lengths. Where a joint's mesh reaches
/// at least twice as far as its points, points of the mesh replace them with the same weight: a
/// prop in a hand, or a thing that has no bones. A joint without points gets its share of the mesh.
MeasuredPoints surface_points(const Skeleton& skeleton);

/// A joint whose surface is its mesh, not a body around its bones.
struct FarMesh {
  int joint;
  double mesh_cm;  // root-mean-square distance from the joint's origin
  double body_cm;  // the same for the body points that the mesh replaces; 0: there are none
};

/// All joints measured on their mesh, in order. Empty for a skeleton without a skin.
std::vector<FarMesh> far_meshes(const Skeleton& skeleton);

}  // namespace mocapress
