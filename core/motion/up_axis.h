// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"
#include "core/motion/source_format.h"

namespace mocapress {

/// The same motion in other axes. From Z up to Y up, x y z become x z -y, as Blender has it; so
/// channels change places and signs, and no angle is computed anew. There and back gives the same
/// numbers.
Motion with_up_axis(const Motion& motion, UpAxis from, UpAxis to);

}  // namespace mocapress
