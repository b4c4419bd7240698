// SPDX-License-Identifier: MIT
// A correction that makes a knee snap is worse than none: how fast it turns tells.
#pragma once

#include <vector>

#include "core/ik/effector.h"
#include "core/motion/clip.h"

namespace mocapress {

/// The joint that bends an effector's limb: the second of its chain, or the only one.
int knee_of(const Effector& effector);

/// The fastest turn of any of the effectors' knees from one frame to the next. radians/s
double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip);

}  // namespace mocapress
