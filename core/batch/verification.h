// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/batch/worst_pose.h"
#include "core/codec/encode/encoder.h"

namespace mocapress {

/// The content of a .mcpr file, measured against its original.
struct Verification {
  /// The decoder: "runtime", the runtime through its C interface and within its default limits, as
  /// in an engine; or "library", for files that no engine plays (the paper's codings and the
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
  std::vector<ContactSpan> contacts;  // contacts of the original's feet
  bool motion = false;                // true: return the decoded clip
  int tiers = 0;                      // measures the first tiers of an adaptive file; 0: all
  SightLimits limits;                 // thresholds of what people notice
};

/// Reads, decodes and measures a file. If a clip in segments is verified without its motion, it is
/// decoded in blocks; then percentiles come from DistanceCounts, and there are no distances. Throws
/// Error if the file cannot be read or has another shape than its original.
Verification verify(std::span<const std::byte> file, const Encoder& original,
                    const VerificationRequest& request = {});

}  // namespace mocapress
