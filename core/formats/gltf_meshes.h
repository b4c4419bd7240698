// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/formats/gltf_file.h"
#include "core/formats/gltf_reader.h"

namespace mocapress {

/// The triangles that the nodes of a file draw, bound to the nodes of its take. A warning names
/// pictures that are not there. Throws InputError.
std::vector<NodeMesh> gltf_meshes(GltfFile& file, const GltfTake& take, Warnings& warnings);

}  // namespace mocapress
