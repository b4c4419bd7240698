// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/batch/worst_pose.h"
#include "core/codec/encoder.h"

namespace mocapress {

/// What a .mcpr file was found to hold, against its original.
struct Verification {
  Distortion distortion;
  WorstPose worst;
  Clip decoded;  // empty where it was not asked for
};

/// Reads, decodes and measures a file. A clip in segments whose motion is not asked for is decoded
/// some frames at a time, its percentiles are those of DistanceCounts, and it has no distances.
/// Throws Error where the file cannot be read or has another shape than its original.
Verification verify(std::span<const std::byte> file, const Encoder& original, bool asks_for_motion);

}  // namespace mocapress
