// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/ik/effector.h"

namespace mocapress {

/// The feet, one effector each: the ball of the foot where there is one, else the ankle. Found by
/// name in any of the usual spellings (ltoes, LeftToeBase, mixamorig:LeftToeBase, Toe_L, toe1-1.L,
/// LeftForeFoot, LeftFoot), and where no name tells, by topology: the lowest joints of the two
/// limbs that reach lowest in the rest pose. Empty when there is nothing like a leg; a foot that
/// nothing turns is left out.
std::vector<Effector> find_feet(const Skeleton& skeleton);

}  // namespace mocapress
