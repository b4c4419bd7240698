// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/formats/gltf_file.h"
#include "core/formats/gltf_reader.h"

namespace mocapress {

/// The triangles that a file's nodes draw, bound to the nodes of its take. A warning names missing
/// pictures. Throws InputError.
std::vector<NodeMesh> gltf_meshes(GltfFile& file, const GltfTake& take, Warnings& warnings);

}  // namespace mocapress
