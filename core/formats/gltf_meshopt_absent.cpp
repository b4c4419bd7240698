// SPDX-License-Identifier: MIT
#include "core/base/error.h"
#include "core/formats/gltf_meshopt.h"

namespace mocapress {

std::string meshopt_unpacked(const MeshoptPacking&, std::string_view) {
  throw Error(
      "is compressed by EXT_meshopt_compression, which this program cannot read: it was built "
      "without libmeshoptimizer");
}

}  // namespace mocapress
