// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/format/compressed_clip.h"

namespace mocapress::test {

/// What the golden files hold: 50 frames of a figure with everything a skeleton can have, axes, end
/// sites, both kinds of channels in several orders, a joint without any. Never change it: a new
/// version of the format gets new files of the same motion.
Motion golden_motion();

/// golden_motion() with a quarter of its coefficients, by nothing but the transform and the coding,
/// so that better selections leave the bytes alone.
CompressedClip golden_clip(Coding coding);

/// The same in steps as Coding::Adaptive has them, one scale for all.
CompressedClip golden_adaptive_clip();

/// golden_adaptive_clip() as a loop, with something lacking at both ends.
CompressedClip golden_ends_clip();

/// golden_adaptive_clip() about turned axes: another motion of the same channels.
CompressedClip golden_turned_clip();

/// 540 frames of the same figure in three segments of Coding::Adaptive, each of another scale.
CompressedClip golden_segmented_clip();

/// The same with ENDS, whose velocity is the first frame's.
CompressedClip golden_velocity_clip();

/// golden_clip(Coding::Rle16) with a correction at ltibia.
CompressedClip golden_corrected_clip();

/// PRIO of a bank that golden_adaptive_clip() taught: the contexts as they are after it.
std::vector<std::byte> golden_lesson();

}  // namespace mocapress::test
