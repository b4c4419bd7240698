// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/skin.h"

namespace mocapress {

/// Finds how much longer a character's bones are than those of `to`; a bone here lies between two
/// joints that carry skin. `bones` are the skin's: their joints are those of `from`, their matrices
/// have the axes of `to`. The result has no bones if no length differs.
OwnLengths own_lengths(const std::vector<SkinBone>& bones, const Skeleton& from, const Skeleton& to,
                       const std::vector<int>& joint_in_to);

/// Positions of a character's joints in a pose of the clip, cm.
std::vector<Eigen::Vector3d> own_origins(const OwnLengths& lengths, const Pose& pose);

}  // namespace mocapress
