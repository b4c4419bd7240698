// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/compressed_clip.h"

namespace mocapress::test {

/// A motion in segments, made by the transform and the coding only: a share of each segment's
/// coefficients, which takes no search. `corrected` adds differences of some centimetres at the
/// ends of two limbs of test::small_skeleton(). `layout` may have one segment.
CompressedClip segmented_clip(const Motion& motion, const SegmentLayout& layout,
                              bool corrected = false, double kept_share = 0.15);

}  // namespace mocapress::test
