// SPDX-License-Identifier: MIT
// Based on: M. Mahoney, "Adaptive Weighing of Context Models for Lossless Data Compression", 2005
// (logistic mixing).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "range_decoder.h"

namespace mocapress::decoder {

/// What is known of the bits of one context: a probability that follows them, fast at first.
struct AdaptiveBit {
  std::uint16_t one = 32768;  // of a set bit, in 65536ths
  std::uint16_t seen = 0;     // counts no further than the slowest rate

  void follow(bool bit);
};

/// The probability of log odds in 256ths, -2048 ... 2048.
std::uint16_t probability_of_log_odds(int log_odds);

/// How much each of several contexts is to be believed. Integers, 65536 = once.
struct MixingWeights {
  static constexpr std::size_t kMost = 8;
  std::array<std::int32_t, kMost> of{};
};

/// The prediction of one bit from several contexts, each of which saw its share of the past.
class MixedBit {
 public:
  MixedBit(std::span<AdaptiveBit* const> contexts, MixingWeights& weights);

  Probability one() const { return one_; }
  void follow(bool bit);

 private:
  std::span<AdaptiveBit* const> contexts_;
  MixingWeights& weights_;
  std::array<std::int32_t, MixingWeights::kMost> evidence_;  // log odds, 256 = e
  Probability one_;
};

}  // namespace mocapress::decoder
