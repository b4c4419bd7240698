// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/compressed_clip.h"

namespace mocapress::test {

/// A motion in segments, by nothing but the transform and the coding: a share of each segment's
/// coefficients, so that encoding takes no time. With `corrected` also differences of some
/// centimetres at the ends of two limbs of test::small_skeleton(); `layout` may be of one segment.
CompressedClip segmented_clip(const Motion& motion, const SegmentLayout& layout,
                              bool corrected = false, double kept_share = 0.15);

}  // namespace mocapress::test
