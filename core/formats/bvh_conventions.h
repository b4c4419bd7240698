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
  // False: the values fit neither well, and the guess is that of Blender and MotionBuilder.
  bool clear;
};

/// Guesses for the roots and for the joints below them. Unset if both conventions agree, since
/// there is no OFFSET or no translation channel.
struct TranslationGuesses {
  std::optional<TranslationGuess> roots;
  std::optional<TranslationGuess> others;
};

/// Guesses by vote. Each joint votes for the one of OFFSET and zero that its mean value is nearer
/// to. A root whose first frame equals its OFFSET replaces it. Other roots follow the joints below
/// them if those are clear, or else their own values: the height's if OFFSET has a height, since a
/// root may walk anywhere.
TranslationGuesses guess_translation(const Motion& motion, UpAxis up = UpAxis::Y);

/// Subtracts offsets from translation channels, of the roots or of the joints below them.
void subtract_offsets(const Skeleton& skeleton, bool of_roots, Clip& clip);

/// The largest side of the box around the rest pose: the height of a figure that stands, the length
/// of one that lies.
double rest_height(const Skeleton& skeleton);

/// True if the figure clearly stands along Z and not along Y, both at rest and on average over
/// time: its head is above its feet. False if no names tell head and feet.
bool stands_along_z(const Motion& motion);

/// The centimetres of a unit in which a person is `height` units tall. Metre, decimetre, CMU's 0.45
/// units to the inch, inch, centimetre and millimetre each hold for a range of heights. Between two
/// ranges the factor changes evenly from one unit to the other. So files whose heights differ by 1
/// % never differ by more than 3 % in the factor, while the nearest unit alone could make one body
/// twice as large as the other. (Ranges wide enough for people leave no room for 1 %.)
double guess_cm_per_unit(double height);

/// 1 / `frame_time`, set to a whole number if it misses one only by rounding; unset if it is no
/// rate at all. A `frame_time` above a second is read as frames per second.
std::optional<double> rate_from_frame_time(double frame_time);

}  // namespace mocapress
