// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/skeleton.h"

namespace mocapress {

/// The name of a joint without its namespace, which a colon ends: mixamorig:Hips is Hips.
std::string without_namespace(const std::string& joint);

/// The namespace that all joints have, with its colon: "mixamorig:". Empty where they share none.
std::string shared_namespace(const Skeleton& skeleton);

/// Identifies a rig by 16 hexadecimal digits, equal for skeletons whose joints have the same names,
/// without namespaces, and the same parents. Lengths, axes and channels do not count.
std::string rig_of(const Skeleton& skeleton);

}  // namespace mocapress
