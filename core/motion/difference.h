// SPDX-License-Identifier: MIT
// Differences that a motion adds to a base, joint by joint, as engines add them
// (mcpr_pose_difference and mcpr_blend_additive in the runtime):
//
//   rotation    = difference * rotation of the base
//   translation = difference + translation of the base
#pragma once

#include "core/motion/clip.h"

namespace mocapress {

/// The differences of a motion to a base of the same joints: one pose, or a clip of as many frames.
/// Joints with two or more rotation channels have three here, about different axes. Throws Error if
/// joints or frames differ.
Motion difference_to(const Motion& base, const Motion& motion);

/// Adds differences as from difference_to() to their base, in the channels of the differences.
Motion sum_of(const Motion& base, const Motion& difference);

/// The differences as a motion whose rest pose is the base's first frame: joints are where base
/// plus difference places them. Only translations of joints below a root go along other axes.
Motion on_base_pose(const Motion& base, const Motion& difference);

}  // namespace mocapress
