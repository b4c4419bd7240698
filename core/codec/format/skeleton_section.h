// SPDX-License-Identifier: MIT
// The section JNTS of a .mcpr file: FORMAT.md.
#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/skeleton.h"
#include "core/runtime/format/file_sections.h"

namespace mocapress {

/// The joints as bytes, before they are coded. Lengths and axes are kept as 32-bit floats.
std::vector<std::byte> joint_bytes(const Skeleton& skeleton);

/// The payload of JNTS.
std::vector<std::byte> write_joints(const Skeleton& skeleton);

/// The payload of JNTS for joints given as bytes.
std::vector<std::byte> write_joints(std::vector<std::byte> joint_bytes, int joints, int channels);

/// Throws FormatError.
Skeleton read_joints(const runtime::FileSections& sections);

}  // namespace mocapress
