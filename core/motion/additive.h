// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress {

/// Whether a motion looks like differences that are to be added to another clip's: no joint ever
/// turns far from rest, and the root stays at the origin, though the figure has legs below it. A
/// figure that stands has its root higher up.
bool looks_additive(const Motion& motion);

}  // namespace mocapress
