// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/motion/clip.h"

namespace mocapress {

/// The baseline of every ratio, as in the paper: the channels as an array of 32-bit floats.
std::size_t raw_bytes(const Clip& clip);

/// raw_bytes / motion_bytes: the skeleton is left out on both sides, as in the paper.
double compression_ratio(const Clip& clip, std::size_t motion_bytes);

/// Motion bits for one joint at one frame.
double bits_per_joint_sample(const Motion& motion, std::size_t motion_bytes);

}  // namespace mocapress
