// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// A figure of 8 joints: a travelling root, a spine that forks into two three-joint limbs with
/// turned axes, end sites, and 1, 2 and 3-channel joints in different rotation orders.
Skeleton small_skeleton();

/// A smooth motion of that figure: each channel is a sum of sines, translations of metres, angles
/// of about a radian. Equal arguments give equal motions.
Motion smooth_motion(int frames, unsigned seed = 1);

}  // namespace mocapress::test
