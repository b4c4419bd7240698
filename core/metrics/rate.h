// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/motion/clip.h"

namespace mocapress {

/// The baseline of every ratio, as in the paper: the channels as an array of 32-bit floats.
inline std::size_t raw_bytes(const Clip& clip) {
  return static_cast<std::size_t>(clip.channels.size()) * sizeof(float);
}

/// raw_bytes / motion_bytes: the skeleton is left out on both sides, as in the paper.
inline double compression_ratio(const Clip& clip, std::size_t motion_bytes) {
  return static_cast<double>(raw_bytes(clip)) / static_cast<double>(motion_bytes);
}

/// Motion bits for one joint at one frame.
inline double bits_per_joint_sample(const Motion& motion, std::size_t motion_bytes) {
  return 8.0 * static_cast<double>(motion_bytes) /
         (static_cast<double>(motion.skeleton.joint_count()) * motion.clip.frames());
}

}  // namespace mocapress
