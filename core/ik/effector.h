// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 5.1.
#pragma once

#include <string>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// A joint whose origin is brought to its original place, and the joints above it that may turn for
/// that: up to, but not including, the joint where its limb leaves the trunk.
struct Effector {
  int joint;
  std::vector<int> chain;  // joints with rotation channels, outermost last
};

/// The effector at a joint. Throws Error when no joint above it in its limb can turn.
Effector effector_at(const Skeleton& skeleton, int joint);

/// The effector at a joint whose chain is all joints that can turn from `top` down to the joint's
/// parent. Throws Error when `top` is not above the joint or cannot turn.
Effector effector_between(const Skeleton& skeleton, int top, int joint);

/// The joints above `joint` up to where its limb leaves the trunk: the root, or the first joint
/// that carries another branch reaching about as far. Toes and twist bones fork too, but do not
/// reach far.
std::vector<int> limb_above(const Skeleton& skeleton, int joint);

/// effector_at(), with an empty chain if nothing above the joint turns.
Effector effector_of_limb(const Skeleton& skeleton, int joint);

}  // namespace mocapress
