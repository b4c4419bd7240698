// SPDX-License-Identifier: MIT
// The SKEL section of a .mcpr file: FORMAT.md.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

/// Lengths and axes are kept as 32-bit floats.
std::vector<std::byte> encode_skeleton(const Skeleton& skeleton);

/// Throws FormatError.
Skeleton decode_skeleton(std::span<const std::byte> payload);

}  // namespace mocapress
