// SPDX-License-Identifier: MIT
// What a BVH file leaves unsaid, guessed from its values.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion/clip.h"

namespace mocapress {

/// Whether translation channels replace OFFSET (MotionBuilder, Mixamo, LAFAN1) or add to it.
enum class TranslationConvention { Adds, Replaces };

struct TranslationGuess {
  TranslationConvention convention;
  bool clear;  // false: the values fit neither well
};

/// Each joint with an OFFSET and translation channels votes for what its values, on average over
/// time, lie nearer to: OFFSET or zero. The root votes only where no other joint can. Nothing when
/// no joint can vote: then both conventions say the same.
std::optional<TranslationGuess> guess_translation(const Motion& motion);

/// Subtracts each joint's offset from its translation channels.
void subtract_offsets(const Skeleton& skeleton, Clip& clip);

/// The largest side of the box around the rest pose: the height of a figure that stands or lies.
double rest_height(const Skeleton& skeleton);

/// 1 when `height`, in file units, is a person's in centimetres (80 to 260); else whichever of
/// metre, millimetre, inch, decimetre and CMU's 0.45 units to the inch makes it nearest to 170 cm.
double guess_cm_per_unit(double height);

/// 1 / `frame_time`, set to a whole number it only misses by rounding; nothing when no rate at all.
/// A `frame_time` above a second is taken for frames per second.
std::optional<double> rate_from_frame_time(double frame_time);

}  // namespace mocapress
