// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/ik/effector.h"

namespace mocapress {

/// The feet, one effector each: the ball of the foot if there is one, else the ankle. Finds them by
/// name in the usual spellings (ltoes, LeftToeBase, mixamorig:LeftToeBase, Toe_L, toe1-1.L,
/// LeftForeFoot, LeftFoot). If no name tells, finds them by topology: the lowest joints of the two
/// limbs that reach lowest in the rest pose. Empty if nothing resembles a leg. Leaves out a foot
/// that no joint turns.
std::vector<Effector> find_feet(const Skeleton& skeleton);

}  // namespace mocapress
