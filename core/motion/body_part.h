// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// Groups of joints that animators think in.
enum class BodyPart { Feet, Hands, Fingers, Head };

inline constexpr BodyPart kBodyParts[] = {BodyPart::Feet, BodyPart::Hands, BodyPart::Fingers,
                                          BodyPart::Head};

/// "feet", "hands", "fingers", "head".
std::string_view name(BodyPart part);

/// The joints of a part by their names, in the usual spellings (rfoot, LeftToeBase, mixamorig:Head,
/// wrist.R, lthumb, RightHandIndex1). Joints with none of these names belong to no part.
std::vector<int> joints_of(const Skeleton& skeleton, BodyPart part);

/// The joints of the head alone: without those that carry it (neck) or lie in it (jaw, eyes), where
/// their names tell them apart.
std::vector<int> head_joints(const Skeleton& skeleton);

}  // namespace mocapress
