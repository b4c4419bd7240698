// SPDX-License-Identifier: MIT
// Corrections of a clip's first and last pose, coded if these are to have smaller errors than the
// coefficients give, and of the velocity at one of them: FORMAT.md, ENDS. Writing and reading share
// this code.
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

/// The corrections that ENDS codes: to the first pose, to the last pose, and to the velocity at
/// either.
inline constexpr int kFirstPose = 0;
inline constexpr int kLastPose = 1;
inline constexpr int kVelocity = 2;  // per frame, away from the end
inline constexpr int kMostEnds = 3;
inline constexpr int kFarthestReach = 127;             // frames
inline constexpr std::uint8_t kVelocityFollows = 128;  // beside the reach of the last pose

/// The share of an end's correction at a frame `frames_away` from it, less than `reach`.
inline float end_share(int end, int frames_away, int reach) {
  const float left = static_cast<float>(reach - frames_away) / static_cast<float>(reach);
  const float share = left * left;
  return end == kVelocity ? static_cast<float>(frames_away) * share : share;
}

/// The largest share at any frame; that of a velocity is at a third of its reach.
inline double largest_end_share(int end, int reach) {
  return end == kVelocity ? 4.0 / 27 * reach : 1;
}

/// The number of frames that each of the three corrections reaches.
struct EndReaches {
  std::uint8_t frames[kMostEnds] = {};  // 0: nothing is added

  bool any() const { return frames[kFirstPose] > 0; }
  int count() const { return frames[kVelocity] > 0 ? kMostEnds : kVelocity; }

  /// The share of an end's correction at a frame, in a clip of `frames_of_clip` frames.
  float share_at(int end, int frame, int frames_of_clip) const {
    const int away = end == kFirstPose ? frame : frames_of_clip - 1 - frame;
    return away < frames[end] ? end_share(end, away, frames[end]) : 0.0F;
  }
};

/// An end's correction of a channel (cm or radians). One step is the channel's times
/// 2^(-step_exponent / 2).
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

  /// True if all of them were there and nothing else.
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
