// SPDX-License-Identifier: MIT
// Layouts that are made from a whole pose of transforms: vectors of four joints, half floats, and
// calls of a writer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

inline bool is_packed(mcpr_layout layout) {
  return layout == MCPR_FOURS || layout == MCPR_HALVES || layout == MCPR_WRITER;
}

/// Floats that a pose takes in any layout.
std::size_t values_of_pose(mcpr_layout layout, std::uint32_t joints);

/// Gives a pose, which has the request's convention, in the request's packed layout.
void pack(const mcpr_sample_request& request, const mcpr_transform* pose, std::uint32_t joints,
          void* out);

}  // namespace mocapress::runtime
