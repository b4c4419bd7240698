// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 5.1.
#pragma once

#include <string>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// A joint whose origin is to be where the original has it, and the joints above it that may turn
/// to bring it there: up to, but not including, the joint where its limb leaves the trunk.
struct Effector {
  int joint;
  std::vector<int> chain;  // joints with rotation channels, outermost last
};

/// The effector at a joint. Throws Error when no joint above it in its limb can turn.
Effector effector_at(const Skeleton& skeleton, int joint);

/// The effector at a joint with all joints that can turn from `top`, above it, down to its parent.
/// Throws Error when `top` is not above the joint or cannot turn.
Effector effector_between(const Skeleton& skeleton, int top, int joint);

/// The feet, one effector each: the ball of the foot where there is one, else the ankle. Found by
/// name in any of the usual spellings (ltoes, LeftToeBase, mixamorig:LeftToeBase, Toe_L, toe1-1.L,
/// LeftForeFoot, LeftFoot), and where no name tells, by topology: the lowest joints of the two
/// limbs that reach lowest in the rest pose. Empty when there is nothing like a leg; a foot that
/// nothing turns is left out.
std::vector<Effector> find_feet(const Skeleton& skeleton);

}  // namespace mocapress
