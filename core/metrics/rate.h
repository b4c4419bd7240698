// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/motion/clip.h"

namespace mocapress {

/// Size of the channels as an array of 32-bit floats: the baseline of every ratio, as in the paper.
inline std::size_t raw_bytes(const Clip& clip) {
  return static_cast<std::size_t>(clip.channels.size()) * sizeof(float);
}

/// raw_bytes / motion_bytes. Both leave out the skeleton, as in the paper.
inline double compression_ratio(const Clip& clip, std::size_t motion_bytes) {
  return static_cast<double>(raw_bytes(clip)) / static_cast<double>(motion_bytes);
}

/// Bits of motion for each joint and frame.
inline double bits_per_joint_sample(const Motion& motion, std::size_t motion_bytes) {
  return 8.0 * static_cast<double>(motion_bytes) /
         (static_cast<double>(motion.skeleton.joint_count()) * motion.clip.frames());
}

}  // namespace mocapress
