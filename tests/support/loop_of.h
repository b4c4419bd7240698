// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// The stretch of a motion whose ends are most alike, closed to a loop in which the last frame
/// repeats the first pose. The remaining difference is removed gradually over the stretch, except
/// in the root's position. It is at least `least_seconds` long. Requires one root and y up. Empty
/// if the motion is shorter.
Motion loop_of(const Motion& motion, double least_seconds = 0.7);

}  // namespace mocapress::test
