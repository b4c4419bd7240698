// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// Groups of joints, as animators name them.
enum class BodyPart { Feet, Hands, Fingers, Head };

inline constexpr BodyPart kBodyParts[] = {BodyPart::Feet, BodyPart::Hands, BodyPart::Fingers,
                                          BodyPart::Head};

/// "feet", "hands", "fingers", "head".
std::string_view name(BodyPart part);

/// The joints whose names put them into a part, in the usual spellings (rfoot, LeftToeBase,
/// mixamorig:Head, wrist.R, lthumb, RightHandIndex1). Joints with none of these names belong to no
/// part.
std::vector<int> joints_of(const Skeleton& skeleton, BodyPart part);

/// The joints with a part's own name: heads without necks, jaws and eyes, hands without wrists,
/// feet without toes. Every joint of the part if none has that name.
std::vector<int> namesakes_of(const Skeleton& skeleton, BodyPart part);

}  // namespace mocapress
