// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/batch/worst_pose.h"
#include "core/codec/encode/encoder.h"

namespace mocapress {

/// What a .mcpr file was found to hold, against its original.
struct Verification {
  /// Who decoded it: "runtime", the runtime decoder through its C interface and within its default
  /// limits, as an engine would; or "library", of what no engine plays (the paper's codings and the
  /// comparison methods).
  std::string_view by;
  Distortion distortion;
  Footskate footskate;
  Visibility visibility;
  WorstPose worst;
  Clip decoded;  // empty where it was not asked for
};

/// What is asked of a verification.
struct VerificationRequest {
  std::vector<ContactSpan> contacts;  // of the feet
  bool motion = false;                // the decoded clip is wanted
};

/// Reads, decodes and measures a file. A clip in segments whose motion is not asked for is decoded
/// some frames at a time, its percentiles are those of DistanceCounts, and it has no distances.
/// Throws Error where the file cannot be read or has another shape than its original.
Verification verify(std::span<const std::byte> file, const Encoder& original,
                    const VerificationRequest& request = {});

}  // namespace mocapress
