// SPDX-License-Identifier: MIT
// The glTF extension EXT_meshopt_compression, as gltfpack writes it. Compiled without
// libmeshoptimizer, unpacking fails with a sentence that says so.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mocapress {

/// The packing of a bufferView: the members of the extension.
struct MeshoptPacking {
  std::size_t count = 0;
  std::size_t stride = 0;  // bytes for each element
  std::string mode;        // ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;      // empty, NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

/// Unpacks count * stride bytes. Throws Error, whose what() continues a sentence that begins with
/// the bufferView's name: "is ...".
std::string meshopt_unpacked(const MeshoptPacking& packing, std::string_view bytes);

}  // namespace mocapress
