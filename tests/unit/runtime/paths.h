// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress {

/// The paths of the runtime that this build and this machine have, the plain one first.
inline std::vector<mcpr_path> existing_paths() {
  std::vector<mcpr_path> paths;
  for (const mcpr_path path :
       {MCPR_PATH_PLAIN, MCPR_PATH_SSE2, MCPR_PATH_AVX2, MCPR_PATH_NEON, MCPR_PATH_WASM})
    if (mcpr_path_exists(path) != 0) paths.push_back(path);
  return paths;
}

}  // namespace mocapress
