// SPDX-License-Identifier: MIT
// Receives a pose from ACL, as an engine would.
#pragma once

#include <acl/core/track_writer.h>
#include <rtm/qvvf.h>

#include <cstdint>
#include <vector>

namespace mocapress {

/// ACL skips tracks equal to the bind pose, which therefore keep their values.
struct PoseWriter final : acl::track_writer {
  std::vector<rtm::qvvf> joints;

  static constexpr acl::default_sub_track_mode get_default_rotation_mode() {
    return acl::default_sub_track_mode::skipped;
  }
  static constexpr acl::default_sub_track_mode get_default_translation_mode() {
    return acl::default_sub_track_mode::skipped;
  }
  static constexpr acl::default_sub_track_mode get_default_scale_mode() {
    return acl::default_sub_track_mode::skipped;
  }
  void RTM_SIMD_CALL write_rotation(std::uint32_t joint, rtm::quatf_arg0 rotation) {
    joints[joint].rotation = rotation;
  }
  void RTM_SIMD_CALL write_translation(std::uint32_t joint, rtm::vector4f_arg0 translation) {
    joints[joint].translation = translation;
  }
  void RTM_SIMD_CALL write_scale(std::uint32_t, rtm::vector4f_arg0) {}
};

}  // namespace mocapress
