// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/compressed_clip.h"

namespace mocapress::test {

/// The motion of the golden files: 50 frames of a figure with everything that a skeleton can have:
/// axes, end sites, both kinds of channels in several orders, a joint without channels. Never
/// change it: a new version of the format gets new files of the same motion.
Motion golden_motion();

/// golden_motion() with a quarter of its coefficients. It uses only the transform and the coding,
/// so that better selections do not change its bytes.
CompressedClip golden_clip(Coding coding);

/// The same in the steps of Coding::Adaptive, one scale for all.
CompressedClip golden_adaptive_clip();

/// golden_adaptive_clip() as a loop, with coded corrections at both ends.
CompressedClip golden_ends_clip();

/// golden_adaptive_clip() with turned axes: a different motion of the same channels.
CompressedClip golden_turned_clip();

/// 540 frames of the same figure in three segments of Coding::Adaptive with different scales.
CompressedClip golden_segmented_clip();

/// golden_segmented_clip() with an ENDS section that corrects the first frame's velocity too.
CompressedClip golden_velocity_clip();

/// golden_clip(Coding::Rle16) with a correction at ltibia.
CompressedClip golden_corrected_clip();

/// PRIO of a bank that learned from golden_adaptive_clip(): the contexts after coding it.
std::vector<std::byte> golden_lesson();

}  // namespace mocapress::test
