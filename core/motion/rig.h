// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The name of a joint without what stands before a colon: mixamorig:Hips is Hips.
std::string without_namespace(const std::string& joint);

/// The namespace that all joints have, with its colon: "mixamorig:". Empty where they share none.
std::string shared_namespace(const Skeleton& skeleton);

/// Tells rigs apart: the same for skeletons whose joints have the same names, without namespaces,
/// and the same parents. Lengths, axes and channels do not count. 16 hexadecimal digits.
std::string rig_of(const Skeleton& skeleton);

}  // namespace mocapress
