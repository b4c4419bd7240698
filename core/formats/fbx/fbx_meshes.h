// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/formats/fbx/fbx_scene.h"

namespace mocapress {

/// The meshes that nodes of a file draw, bound to the nodes of its take: one for each material of
/// each. Pictures are in the file, or beside it by their name; a warning says which are not there.
/// Throws InputError.
std::vector<NodeMesh> fbx_meshes(FbxFile& file, const FbxTake& take, Warnings& warnings);

/// A shape of a node of version 6, which has it within its record; null: none of that name.
const FbxRecord* fbx_shape_named(const FbxRecords& records, const FbxRecord& model,
                                 std::string_view name);

}  // namespace mocapress
