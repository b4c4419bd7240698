// SPDX-License-Identifier: MIT
// The glTF extension KHR_draco_mesh_compression. Compiled without libdraco, unpacking fails with a
// sentence that says so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace mocapress {

struct DracoMesh {
  struct Attribute {
    std::size_t components = 0;
    std::vector<double> values;  // for each vertex; integers as stored, not normalised
  };

  std::size_t vertices = 0;
  std::vector<std::uint32_t> corners;           // three for each triangle
  std::map<std::size_t, Attribute> attributes;  // by Draco's unique id
};

/// Unpacks a mesh. Throws Error, whose what() continues a sentence that begins with the mesh's
/// name: "is ...".
DracoMesh draco_unpacked(std::string_view bytes);

}  // namespace mocapress
