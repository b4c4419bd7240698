// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/codec/encode/options/target.h"
#include "core/feet/footskate.h"
#include "core/metrics/distortion.h"
#include "core/metrics/visibility.h"

namespace mocapress {

/// What a compression came to.
struct Measurement {
  int frames = 0;
  int channels = 0;
  double sample_rate_hz = 0;
  std::size_t raw_bytes = 0;  // as 32-bit floats, skeleton left out
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;
  double ratio = 0;                         // raw_bytes / motion_bytes
  std::optional<double> coefficient_ratio;  // of wavelets
  double eps_bone_ends_cm = 0;
  double eps_joint_origins_cm = 0;
  double max_error_cm = 0;
  double p95_error_cm = 0;
  double p99_error_cm = 0;
  BodyFigures body;
  std::optional<Seen> seen;  // unset: in rows from before it was measured
  int worst_frame = 0;
  int contacts = 0;                      // of the feet with the ground, in the original
  std::optional<double> footskate_cm;    // over all contacts; unset: there are none
  std::optional<SlidePerContact> slide;  // the same footskate, a contact
  std::optional<double> ik_ratio_used;   // with IK: r_IK, asked for or found
  std::optional<std::size_t> ik_bytes;
  std::optional<double> knee_speed_ratio;  // with IK: its speed over the original's
  std::optional<int> iterations;           // of the last annealing
  double encode_seconds = 0;               // search for the target and all

  /// What eps_x and the maximum are in a weighting.
  double eps_cm(Weighting weighting) const;
  double max_cm(Weighting weighting) const;

  /// Of the kind a target is of; 0: unknown.
  double quantity(Target::Kind kind, Weighting weighting) const;
  double ms_per_frame() const { return frames > 0 ? 1000 * encode_seconds / frames : 0; }

  bool operator==(const Measurement&) const = default;
};

}  // namespace mocapress
