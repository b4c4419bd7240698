// SPDX-License-Identifier: MIT
// What Weighting::Surface looks at.
#pragma once

#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

/// Four points for each stretch of body_limbs(), with the mean and the second moments of a
/// cylinder's surface; shell_points() in a skeleton without lengths. What a joint carries of a mesh
/// takes the place of its points where it reaches twice as far, with as much weight: a prop in a
/// hand, or a thing that has no bones. A joint that had none has its share of the mesh.
MeasuredPoints surface_points(const Skeleton& skeleton);

/// A joint whose surface is its mesh, not a body around its bones.
struct FarMesh {
  int joint;
  double mesh_cm;  // root mean square distance from the joint's origin
  double body_cm;  // likewise of what stood there; 0: nothing did
};

/// All of them, in the order of joints. Empty for a skeleton without a skin.
std::vector<FarMesh> far_meshes(const Skeleton& skeleton);

}  // namespace mocapress
