// SPDX-License-Identifier: MIT
// Makes the layouts that need a whole pose of transforms first: vectors of four joints, half
// floats, and calls of a writer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

inline bool is_packed(mcpr_layout layout) {
  return layout == MCPR_FOURS || layout == MCPR_HALVES || layout == MCPR_WRITER;
}

/// Size of a pose in floats, for any layout.
std::size_t values_of_pose(mcpr_layout layout, std::uint32_t joints);

/// Converts a pose to the packed layout of the request. The pose has the convention of the request.
void pack(const mcpr_sample_request& request, const mcpr_transform* pose, std::uint32_t joints,
          void* out);

}  // namespace mocapress::runtime
