// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/encode/segments.h"
#include "core/codec/encode/targeted_encode.h"

namespace mocapress {

/// encode_to_target() of a long clip by a closed loop, one segment after the other, in memory that
/// does not grow with the clip. All segments have one scale of steps,
/// as the whole clip would, and the target is that of the whole clip. Cancelled, it codes what is
/// left roughly.
TargetedEncoding encode_in_segments(const ClipAnalysis& analysis, const EncodeOptions& options,
                                    const SegmentLayout& layout,
                                    const Observer<EncodeProgress>& observer);

}  // namespace mocapress
