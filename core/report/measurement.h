// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/codec/encode/options/target.h"
#include "core/feet/footskate.h"
#include "core/metrics/distortion.h"
#include "core/metrics/visibility.h"

namespace mocapress {

/// Measurements of one compression.
struct Measurement {
  int frames = 0;
  int channels = 0;
  double sample_rate_hz = 0;
  std::size_t raw_bytes = 0;  // the motion as 32-bit floats, without skeleton
  std::size_t motion_bytes = 0;
  std::size_t file_bytes = 0;
  double ratio = 0;                         // raw_bytes / motion_bytes
  std::optional<double> coefficient_ratio;  // wavelet methods only
  double eps_bone_ends_cm = 0;
  double eps_joint_origins_cm = 0;
  double max_error_cm = 0;  // this and the two below: over bone ends
  double p95_error_cm = 0;
  double p99_error_cm = 0;
  BodyFigures body;
  Seen seen;
  int worst_frame = 0;                   // by the weighting that the clip was encoded with
  int contacts = 0;                      // number of foot contacts in the original
  std::optional<double> footskate_cm;    // sum over all contacts; unset without contacts
  std::optional<SlidePerContact> slide;  // footskate for each contact
  std::optional<double> ik_ratio_used;   // with IK only: r_IK, given or found
  std::optional<std::size_t> ik_bytes;
  std::optional<double> knee_speed_ratio;  // with IK only: fastest knee / that of the original
  std::optional<int> iterations;           // of the last annealing
  double encode_seconds = 0;               // includes the search for the target

  /// Errors in a weighting, as from Distortion::spread(), but without the place of the largest.
  Spread spread(Weighting weighting) const;
  double eps_cm(Weighting weighting) const { return spread(weighting).rms; }
  double max_cm(Weighting weighting) const { return spread(weighting).max.cm; }

  /// The measured value in the unit of a target of this kind; 0 if unknown.
  double quantity(Target::Kind kind, Weighting weighting) const;
  double ms_per_frame() const { return frames > 0 ? 1000 * encode_seconds / frames : 0; }

  bool operator==(const Measurement&) const = default;
};

}  // namespace mocapress
