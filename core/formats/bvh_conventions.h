// SPDX-License-Identifier: MIT
// Guesses, from its values, what a BVH file does not state.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion/clip.h"
#include "core/motion/source_format.h"

namespace mocapress {

/// A convention guessed from the values.
struct TranslationGuess {
  TranslationConvention convention;
  // False: the values fit neither convention well. The guess is then Replaces, as Blender and
  // MotionBuilder assume.
  bool clear;
};

/// Guesses for the roots and for the joints below them. Unset if both conventions agree, since
/// there is no OFFSET or no translation channel.
struct TranslationGuesses {
  std::optional<TranslationGuess> roots;
  std::optional<TranslationGuess> others;
};

/// Joints below the roots vote: each for Replaces if its mean translation is nearer to OFFSET than
/// to zero, else for Adds. A root whose first frame equals its OFFSET replaces it. Other roots
/// follow the vote if it is clear, or else their own mean translation. If OFFSET is mostly height,
/// only the mean height counts, since a root may walk anywhere.
TranslationGuesses guess_translation(const Motion& motion, UpAxis up = UpAxis::Y);

/// Subtracts each joint's OFFSET from its translation channels: for the roots if `of_roots`, else
/// for all joints below them.
void subtract_offsets(const Skeleton& skeleton, bool of_roots, Clip& clip);

/// The largest side of the box around the rest pose: the height of a standing figure, the length of
/// a lying one.
double rest_height(const Skeleton& skeleton);

/// True if the figure clearly stands along Z and not along Y, both at rest and on average over
/// time: its head is above its feet. False if no joint names identify head and feet.
bool stands_along_z(const Motion& motion);

/// Guesses the centimetres per unit of a file in which a person is `height` units tall. Metre,
/// decimetre, CMU's unit (0.45 to the inch), inch, centimetre and millimetre each hold for a range
/// of heights. Between two ranges the factor changes gradually from one unit to the other. So files
/// whose heights differ by 1 % get factors that differ by at most 3 %, while the nearest unit alone
/// could make one body twice as large as another. (The ranges must be wide enough for people, so
/// the gaps between them are too narrow for less than 3 %.)
double guess_cm_per_unit(double height);

/// 1 / `frame_time`, rounded if it is within 0.01 % of a whole number; unset if `frame_time` is
/// nonsense. A `frame_time` above a second is read as frames per second.
std::optional<double> rate_from_frame_time(double frame_time);

}  // namespace mocapress
