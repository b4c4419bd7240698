// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress {

/// True if a motion looks like differences to be added to another clip: no joint turns far from
/// rest, and the root stays at the origin although the figure has legs below it. The root of a
/// standing figure is higher up.
bool looks_additive(const Motion& motion);

}  // namespace mocapress
