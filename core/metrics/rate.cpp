// SPDX-License-Identifier: MIT
#include "core/metrics/rate.h"

namespace mocapress {

std::size_t raw_bytes(const Clip& clip) {
  return static_cast<std::size_t>(clip.channels.size()) * sizeof(float);
}

double compression_ratio(const Clip& clip, std::size_t motion_bytes) {
  return static_cast<double>(raw_bytes(clip)) / static_cast<double>(motion_bytes);
}

double bits_per_joint_sample(const Motion& motion, std::size_t motion_bytes) {
  return 8.0 * static_cast<double>(motion_bytes) /
         (static_cast<double>(motion.skeleton.joint_count()) * motion.clip.frames());
}

}  // namespace mocapress
