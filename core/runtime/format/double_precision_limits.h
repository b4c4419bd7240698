// SPDX-License-Identifier: MIT
// Decides which signals are decoded in double precision. With floats, the inverse transform has an
// error of about 1e-6 of the signal's largest sample; this error must not move any joint by 1e-3
// cm.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/runtime/format/joint_model.h"

namespace mocapress::runtime {

inline constexpr float kDoublePrecisionLength = 1000;  // cm

/// For each joint, finds the distance along the bones to the furthest joint or end site below it,
/// in cm.
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

/// The largest sample of a channel that floats are good enough for. For a translation, that is
/// kDoublePrecisionLength; for a rotation, the angle that moves the end of the joint's reach as
/// far.
inline float double_precision_limit(std::uint8_t kind, float reach) {
  constexpr float kLeastReach = 0.01F;  // cm
  return is_rotation(kind) ? kDoublePrecisionLength / std::max(reach, kLeastReach)
                           : kDoublePrecisionLength;
}

}  // namespace mocapress::runtime
