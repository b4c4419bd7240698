// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"

namespace mocapress::test {

/// The same motion on a rig as games have them: a root that walks on the floor and heads where the
/// hips do, below it the joints, each with six channels (translations that stay zero but for the
/// hips' height; angles in the order ZXY, its own axes those of its parent), end sites at zero. Of
/// a motion with one root, y up. Joint j + 1 is where joint j was.
Motion game_like(const Motion& motion);

}  // namespace mocapress::test
