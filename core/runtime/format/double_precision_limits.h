// SPDX-License-Identifier: MIT
// Which samples floats are too coarse for: their error after all bands is some 1e-6 of the largest,
// and what they move should not be off by 1e-3 cm.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/runtime/format/joint_model.h"

namespace mocapress::runtime {

inline constexpr float kDoublePrecisionLength = 1000;  // cm

/// How far from each joint the furthest joint or end site below it can be. cm
inline void find_reach(const JointModel* joints, int count, float* reach) {
  for (int j = 0; j < count; ++j) {
    const float* const end = joints[j].end_site;
    reach[j] = std::sqrt(end[0] * end[0] + end[1] * end[1] + end[2] * end[2]);
  }
  for (int j = count - 1; j >= 0; --j)
    if (const int parent = joints[j].parent; parent >= 0)
      reach[parent] =
          std::max(reach[parent], reach[j] + static_cast<float>(norm(joints[j].offset)));
}

/// Samples beyond this are decoded in double precision: so many cm, or an angle that moves the
/// joint's reach as far.
inline float double_precision_limit(std::uint8_t kind, float reach) {
  constexpr float kLeastReach = 0.01F;  // cm
  return is_rotation(kind) ? kDoublePrecisionLength / std::max(reach, kLeastReach)
                           : kDoublePrecisionLength;
}

}  // namespace mocapress::runtime
