// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/scene.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "core/formats/node_motion.h"

namespace mocapress {

/// Where pictures are looked for that are not in the scene, beside `file`, and who is told of those
/// that are not there.
struct FbxPictures {
  const std::string& file;
  Warnings& warnings;
};

/// The meshes of a scene: those with bones once, others wherever a node draws them. `index_of` the
/// nodes of a take, among which are all but leaves.
std::vector<NodeMesh> fbx_meshes(const aiScene& scene, const std::vector<AnimatedNode>& nodes,
                                 const std::unordered_map<const aiNode*, int>& index_of,
                                 const FbxPictures& pictures);

}  // namespace mocapress
