// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/skin.h"

namespace mocapress {

/// Finds by how much a skin's bones, between the joints that carry it, are longer than the bones of
/// `to`. `bones` are those of the skin, with joints of `from`, in the axes of `to`. The result has
/// no bones if no length differs.
OwnLengths own_lengths(const std::vector<SkinBone>& bones, const Skeleton& from, const Skeleton& to,
                       const std::vector<int>& joint_in_to);

/// Positions of a character's joints in a pose of the clip, cm.
std::vector<Eigen::Vector3d> own_origins(const OwnLengths& lengths, const Pose& pose);

}  // namespace mocapress
