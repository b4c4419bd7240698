// SPDX-License-Identifier: MIT
// What a BVH file leaves unsaid, guessed from its values.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion/clip.h"
#include "core/motion/source_format.h"

namespace mocapress {

/// What the values say of a convention.
struct TranslationGuess {
  TranslationConvention convention;
  bool clear;  // false: they fit neither well, and it is what Blender and MotionBuilder do
};

/// Of the roots and of the joints below them; unset where both conventions say the same, for want
/// of an OFFSET or of translation channels.
struct TranslationGuesses {
  std::optional<TranslationGuess> roots;
  std::optional<TranslationGuess> others;
};

/// Joints vote for what their values, on average over time, lie nearer to: OFFSET or zero. A root
/// whose first frame is its OFFSET replaces it. Other roots do as the joints below them clearly do
/// or, where there is no telling by those, as their own values say: by the height where OFFSET has
/// one, for a root may walk anywhere.
TranslationGuesses guess_translation(const Motion& motion, UpAxis up = UpAxis::Y);

/// Subtracts offsets from translation channels: those of the roots or of the joints below them.
void subtract_offsets(const Skeleton& skeleton, bool of_roots, Clip& clip);

/// The largest side of the box around the rest pose: the height of a figure that stands or lies.
double rest_height(const Skeleton& skeleton);

/// Whether the figure evidently stands along Z and not along Y, in its rest pose and on average
/// over time: its head above its feet. False where no names tell them.
bool stands_along_z(const Motion& motion);

/// The centimetres of a unit in which a person is `height` units tall. Metre, decimetre, CMU's 0.45
/// units to the inch, inch, centimetre and millimetre are each taken as they are for a range of
/// heights. Between two ranges the factor goes evenly from one unit to the other: files whose
/// heights differ by 1 % never differ by more than 3 % in the factor, where the nearest unit alone
/// would make one body twice as large as the other. (Ranges that are wide enough for people leave
/// no room for 1 %.)
double guess_cm_per_unit(double height);

/// 1 / `frame_time`, set to a whole number it only misses by rounding; nothing when no rate at all.
/// A `frame_time` above a second is taken for frames per second.
std::optional<double> rate_from_frame_time(double frame_time);

}  // namespace mocapress
