// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/batch/worst_pose.h"
#include "core/codec/encode/encoder.h"

namespace mocapress {

/// Measurements of a .mcpr file against its original.
struct Verification {
  /// The decoder that was used. "runtime": through its C interface and within its default limits,
  /// as in an engine. "library": for files that no engine plays (the paper's codings and the
  /// comparison methods).
  std::string_view by;
  Distortion distortion;
  Footskate footskate;
  Visibility visibility;
  WorstPose worst;
  Clip decoded;  // empty unless requested
};

/// Options of a verification.
struct VerificationRequest {
  std::vector<ContactSpan> contacts;  // foot contacts of the original
  bool motion = false;                // true: return the decoded clip
  int tiers = 0;                      // number of tiers to measure in an adaptive file; 0: all
  SightLimits limits;                 // thresholds of what viewers notice
};

/// Reads, decodes and measures a file. A clip in segments is decoded in blocks unless its motion is
/// requested; then percentiles come from DistanceCounts, and there are no distances for each frame.
/// Throws Error if the file cannot be read, or if frames, rate or skeleton differ from the
/// original's.
Verification verify(std::span<const std::byte> file, const Encoder& original,
                    const VerificationRequest& request = {});

}  // namespace mocapress
