// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/formats/gltf_file.h"
#include "core/formats/gltf_reader.h"

namespace mocapress {

/// The triangles that the nodes of a file draw, bound to the nodes of its take. Throws InputError.
std::vector<NodeMesh> gltf_meshes(GltfFile& file, const GltfTake& take);

}  // namespace mocapress
