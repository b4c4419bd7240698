// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/formats/fbx/fbx_scene.h"

namespace mocapress {

/// The meshes of a file's nodes, one for each material, bound to the nodes of its take. Pictures
/// are in the file, or beside it under their names; a warning lists missing ones. Throws
/// InputError.
std::vector<NodeMesh> fbx_meshes(FbxFile& file, const FbxTake& take, Warnings& warnings);

/// The shape with this name in the record of a version 6 node, which holds its shapes; null: none.
const FbxRecord* fbx_shape_named(const FbxRecords& records, const FbxRecord& model,
                                 std::string_view name);

}  // namespace mocapress
