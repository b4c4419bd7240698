// SPDX-License-Identifier: MIT
// Converts sampled poses to an engine's axes, unit of length, order of quaternions and space.
#pragma once

#include <cstdint>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// True if the three axes are x, y and z, each once, and the factor of length is finite.
bool is_convention(const mcpr_convention& convention);

/// True if each joint's parent comes before it.
bool are_parents(const std::int16_t* parents, std::uint32_t joints);

/// Converts a pose from the spaces of the joints' parents to the character's space. Quaternions
/// must be w x y z.
void place_in_model(mcpr_layout layout, const std::int16_t* parents, std::uint32_t joints,
                    float* pose);

/// Converts a pose from the clip's convention to the given one.
void convert(const mcpr_convention& convention, mcpr_layout layout, std::uint32_t joints,
             float* pose);

}  // namespace mocapress::runtime
