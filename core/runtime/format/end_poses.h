// SPDX-License-Identifier: MIT
// What the first and last frame of a clip still lack, where more was promised of them than the
// coefficients give, and the velocity at one of them: FORMAT.md, ENDS.
// The same walk for writing and reading.
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

/// What ENDS adds to: the pose of the first frame, that of the last, and the velocity at either.
inline constexpr int kFirstPose = 0;
inline constexpr int kLastPose = 1;
inline constexpr int kVelocity = 2;  // a frame, away from the end
inline constexpr int kMostEnds = 3;
inline constexpr int kFarthestReach = 127;             // frames
inline constexpr std::uint8_t kVelocityFollows = 128;  // beside the reach of the last pose

/// How much of what an end lacks goes to a frame so many frames from it, less than `reach`.
inline float end_share(int end, int frames_away, int reach) {
  const float left = static_cast<float>(reach - frames_away) / static_cast<float>(reach);
  const float share = left * left;
  return end == kVelocity ? static_cast<float>(frames_away) * share : share;
}

/// The most that goes to any frame: a velocity's at a third of its reach.
inline double largest_end_share(int end, int reach) {
  return end == kVelocity ? 4.0 / 27 * reach : 1;
}

/// How many frames have a share in what each of the three lacks.
struct EndReaches {
  std::uint8_t frames[kMostEnds] = {};  // 0: nothing is added

  bool any() const { return frames[kFirstPose] > 0; }
  int count() const { return frames[kVelocity] > 0 ? kMostEnds : kVelocity; }

  /// How much of what an end lacks goes to a frame of a clip of so many.
  float share_at(int end, int frame, int frames_of_clip) const {
    const int away = end == kFirstPose ? frame : frames_of_clip - 1 - frame;
    return away < frames[end] ? end_share(end, away, frames[end]) : 0.0F;
  }
};

/// What an end lacks in a channel, in steps of the channel times 2^(-step_exponent / 2). cm or
/// radians
inline float end_value(std::int32_t steps, float step_of_channel, int step_exponent) {
  const float whole = std::ldexp(step_of_channel, -(step_exponent >> 1));
  return static_cast<float>(steps) * (step_exponent % 2 == 0 ? whole : whole * 0x1.6a09e6p-1F);
}

/// Codes whole numbers, with signs. `Bits` as of CoefficientCoder.
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

/// Reads the coded numbers of ENDS: those of the first frame, channel by channel, then the last;
/// after either those of its velocity, if it has one.
class EndReader {
 public:
  explicit EndReader(const Bytes& coded) : coded_(coded), bits_(coded.data, coded.size) {}

  std::int32_t next() { return coder_.code(bits_, 0); }

  /// Whether all of them were there and nothing else.
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
