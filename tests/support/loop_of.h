// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// The stretch of a motion whose two ends are most alike, closed to a loop whose last frame shows
/// the first pose again: what is left of the difference is taken back little by little, but for
/// where the root stands. At least so long; of a motion with one root, y up. Empty where the motion
/// is shorter.
Motion loop_of(const Motion& motion, double least_seconds = 0.7);

}  // namespace mocapress::test
