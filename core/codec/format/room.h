// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/motion/skeleton.h"
#include "core/runtime/format/segment_layout.h"

namespace mocapress {

using runtime::SegmentLayout;

/// What decides whether a clip fits into a .mcpr file.
struct ClipShape {
  const Skeleton& skeleton;
  double sample_rate_hz;
  SegmentLayout segments;  // and with them the frames
  int effectors = 0;       // of an IK correction
};

/// Throws Error, which says what is too large and what the limit is, where no .mcpr file can hold a
/// clip: core/runtime/format/format_limits.h. Known before it is encoded.
void check_room(const ClipShape& clip);

/// The same of a file of so many bytes, which bound how many values it may hold.
void check_room(std::uint64_t values, std::uint64_t file_bytes);

}  // namespace mocapress
