// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The name of a joint without what stands before a colon: mixamorig:Hips is Hips.
std::string without_namespace(const std::string& joint);

/// Tells rigs apart: the same for skeletons whose joints have the same names, without namespaces,
/// and the same parents. Lengths, axes and channels do not count. 16 hexadecimal digits.
std::string rig_of(const Skeleton& skeleton);

}  // namespace mocapress
