// SPDX-License-Identifier: MIT
// The sections SKEL and JNTS of a .mcpr file: FORMAT.md.
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

/// The same as the section JNTS, which the runtime decoder reads.
std::vector<std::byte> encode_joints(const Skeleton& skeleton);

/// Throws FormatError. `offset`: of the payload in its file.
Skeleton decode_joints(std::span<const std::byte> payload, std::size_t offset);

}  // namespace mocapress
