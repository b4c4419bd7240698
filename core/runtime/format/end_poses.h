// SPDX-License-Identifier: MIT
// Corrections at the ends of a clip: FORMAT.md, ENDS. They make the errors of the first and of the
// last pose smaller than the coefficients do, and may correct the velocity at the last pose.
// Writing and reading share this code.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/runtime/format/digit_coder.h"
#include "core/runtime/format/range_decoder.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kLeastEndStepExponent = -16;
inline constexpr int kMostEndStepExponent = 48;

/// The corrections that ENDS codes: to the first pose, to the last pose, and to the velocity at the
/// last pose.
inline constexpr int kFirstPose = 0;
inline constexpr int kLastPose = 1;
inline constexpr int kVelocity = 2;  // change per frame, away from the last pose
inline constexpr int kMostEnds = 3;
inline constexpr int kFarthestReach = 127;             // frames
inline constexpr std::uint8_t kVelocityFollows = 128;  // flag beside the reach of the last pose

/// The weight of an end correction `frames_away` frames from its end. frames_away < reach.
inline float end_share(int end, int frames_away, int reach) {
  const float left = static_cast<float>(reach - frames_away) / static_cast<float>(reach);
  const float share = left * left;
  return end == kVelocity ? static_cast<float>(frames_away) * share : share;
}

/// The largest weight at any frame. A velocity has it at a third of its reach.
inline double largest_end_share(int end, int reach) {
  return end == kVelocity ? 4.0 / 27 * reach : 1;
}

/// For each of the three corrections: the number of frames that it changes.
struct EndReaches {
  std::uint8_t frames[kMostEnds] = {};  // 0: there is no such correction

  bool any() const { return frames[kFirstPose] > 0; }
  int count() const { return frames[kVelocity] > 0 ? kMostEnds : kVelocity; }

  /// The weight of an end correction at a frame, in a clip of `frames_of_clip` frames.
  float share_at(int end, int frame, int frames_of_clip) const {
    const int away = end == kFirstPose ? frame : frames_of_clip - 1 - frame;
    return away < frames[end] ? end_share(end, away, frames[end]) : 0.0F;
  }
};

/// The value of an end correction for a channel, in cm or radians. Its quantisation step is the
/// channel's step times 2^(-step_exponent / 2).
inline float end_value(std::int32_t steps, float step_of_channel, int step_exponent) {
  const float whole = std::ldexp(step_of_channel, -(step_exponent >> 1));
  return static_cast<float>(steps) * (step_exponent % 2 == 0 ? whole : whole * 0x1.6a09e6p-1F);
}

/// Codes signed integers. `Bits` as in CoefficientCoder.
class EndCoder {
 public:
  template <typename Bits>
  std::int32_t code(Bits& bits, std::int32_t steps) {
    const std::int32_t magnitude = magnitude_.code(bits, std::abs(steps));
    if (magnitude == 0) return 0;
    return bits.code(steps < 0, kEvenOdds) ? -magnitude : magnitude;
  }

 private:
  DigitCoder magnitude_;
};

/// Reads the coded numbers of ENDS, channel by channel: first all of the first pose, then those of
/// the last pose, then those of the velocity, if there is one.
class EndReader {
 public:
  explicit EndReader(const Bytes& coded) : coded_(coded), bits_(coded.data, coded.size) {}

  std::int32_t next() { return coder_.code(bits_, 0); }

  /// Fails if numbers were missing or damaged, or if bytes are left over.
  mcpr_result finish() const {
    if (!bits_.failed() && bits_.is_at_end()) return kOk;
    return failure(MCPR_INVALID, coded_.offset + bits_.position(), "the coded ends are damaged");
  }

 private:
  Bytes coded_;
  RangeDecoder bits_;
  EndCoder coder_;
};

}  // namespace mocapress::runtime
