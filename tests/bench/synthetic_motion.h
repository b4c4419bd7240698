// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// 2,000 frames at 120 Hz of a figure built like CMU's: 62 channels, 25 joints. The motion is
/// smooth with some noise, and the same at every call.
const Motion& synthetic_motion();

}  // namespace mocapress::test
