// SPDX-License-Identifier: MIT
// Long clips fall into segments that overlap, each encoded by itself: FORMAT.md, SEGS.

#pragma once

#include "core/base/progress.h"
#include "core/codec/encode/options/encode_settings.h"
#include "core/runtime/format/segment_layout.h"

namespace mocapress {

class ClipAnalysis;
struct Trial;

using runtime::SegmentLayout;

/// Cuts a clip into as few segments as the plan allows, as even in length as possible. A short clip
/// is one segment.
SegmentLayout even_segments(int frames, const SegmentPlan& plan);

/// Encodes a long clip by a closed loop to a target, one segment after the other, in memory that
/// does not grow with the clip. All segments share the scale that the whole clip would have, and
/// the target is the whole clip's. When cancelled, it codes the remaining segments roughly.
Trial encode_in_segments(const ClipAnalysis& analysis, const EncodeSettings& settings,
                         const SegmentLayout& layout, const Observer<EncodeProgress>& observer);

}  // namespace mocapress
