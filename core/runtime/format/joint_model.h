// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/kinematics.h"
#include "core/runtime/format/space.h"

namespace mocapress::runtime {

inline constexpr int kMostJoints = 4096;
inline constexpr int kMostChannelsOfJoint = 6;

/// A joint as the decoder keeps it. A point moves from the joint's frame to its parent's by
///
///   x_in_parent = offset + translation + rotation * x_in_joint
///   rotation    = parent_from_axes * R * axes_from_joint
///
/// where R is the product of the rotation channels, the first leftmost.
struct JointModel {
  Vector3 offset;            // cm, in the parent's frame
  Matrix3 parent_from_axes;  // identity unless has_axes
  Matrix3 axes_from_joint;   // identity unless has_axes
  float end_site[3] = {};    // cm, in the joint's frame
  std::uint32_t name = 0;    // offset into the names
  std::int32_t parent = -1;  // -1: a root
  std::uint16_t first_channel = 0;
  std::uint8_t channels = 0;
  std::uint8_t kinds[kMostChannelsOfJoint] = {};  // 0 1 2: translation x y z; 3 4 5: rotation
  bool has_axes = false;
  bool has_end_site = false;

  bool turns() const {
    for (int c = 0; c < channels; ++c)
      if (is_rotation(kinds[c])) return true;
    return false;
  }
};

/// A joint's transform to world space: x_in_world = origin + world_from_joint * x_in_joint.
struct JointPlace {
  Matrix3 world_from_joint;
  Vector3 origin;  // cm
};

}  // namespace mocapress::runtime
