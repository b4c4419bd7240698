// SPDX-License-Identifier: MIT
#include "core/base/error.h"
#include "core/formats/gltf_draco.h"

namespace mocapress {

DracoMesh draco_unpacked(std::string_view) {
  throw Error(
      "is compressed by KHR_draco_mesh_compression, which this program cannot read: it was built "
      "without libdraco");
}

}  // namespace mocapress
