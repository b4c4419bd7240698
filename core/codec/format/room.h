// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/motion/skeleton.h"
#include "core/runtime/format/segment_layout.h"

namespace mocapress {

using runtime::SegmentLayout;

/// The sizes that decide whether a clip fits into a .mcpr file.
struct ClipShape {
  const Skeleton& skeleton;
  double sample_rate_hz;
  SegmentLayout segments;  // also give the number of frames
  int effectors = 0;       // number of effectors of an IK correction
};

/// Throws Error, which says what is too large and what the limit is, where no .mcpr file can hold
/// the clip (core/runtime/format/format_limits.h). Called before encoding.
void check_room(const ClipShape& clip);

/// Throws Error where a file of `file_bytes` bytes may not hold this many values.
void check_room(std::uint64_t values, std::uint64_t file_bytes);

}  // namespace mocapress
