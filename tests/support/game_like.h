// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// The same motion on a rig like those of games: a root on the floor that faces as the hips do, and
/// below it the joints with six channels each (translations of zero except the hips' height; angles
/// in order ZXY about the parent's axes), and end sites at zero. Requires one root and y up. Joint
/// j becomes joint j + 1.
Motion game_like(const Motion& motion);

}  // namespace mocapress::test
