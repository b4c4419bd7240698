// SPDX-License-Identifier: MIT
// Long clips fall into segments that overlap, each encoded by itself: FORMAT.md, SEGS.

#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/codec/encode/effort.h"
#include "core/codec/format/segment_layout.h"
#include "core/feet/contact_spans.h"
#include "core/motion/clip.h"

namespace mocapress {

class ClipAnalysis;
struct EncodeOptions;
struct TargetedEncoding;

using runtime::SegmentLayout;

/// How long clips are cut. Encoding a segment takes some 150 bytes for each channel and frame.
struct SegmentPlan {
  int longest = 12288;  // frames, 256 at least; a longer clip falls into several
  int overlap = 48;     // frames that neighbours share, 1 at least
};

/// As few segments as the plan allows, as even in length as possible. A short clip is one segment.
SegmentLayout even_segments(int frames, const SegmentPlan& plan);

/// Some frames of a motion, and the contacts in them. Frames are counted from the first of these.
Motion frames_of(const Motion& motion, int first, int count);
std::vector<ContactSpan> frames_of(const std::vector<ContactSpan>& contacts, int first, int count);

/// encode_to_target() of a long clip by a closed loop, one segment after the other, in memory that
/// does not grow with the clip. All segments have one scale of steps, as the whole clip would, and
/// the target is that of the whole clip. When it is cancelled, it codes the rest roughly.
TargetedEncoding encode_in_segments(const ClipAnalysis& analysis, const EncodeOptions& options,
                                    const SegmentLayout& layout,
                                    const Observer<EncodeProgress>& observer);

}  // namespace mocapress
