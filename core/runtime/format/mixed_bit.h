// SPDX-License-Identifier: MIT
// Based on: M. Mahoney, "Adaptive Weighing of Context Models for Lossless Data Compression", 2005
// (logistic mixing).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/runtime/format/range_decoder.h"

namespace mocapress::runtime {

/// Log odds are natural logarithms, in 256ths: 256 stands for odds of e.
inline constexpr std::int32_t kLogOddsRange = 2047;  // -8 ... 8

/// The probability, in 65536ths, that belongs to log odds.
constexpr std::int32_t squash(std::int32_t log_odds) {
  // 65536 / (1 + exp(-x / 2)) for x = -16 ... 16.
  constexpr std::array<std::int32_t, 33> kSquashed = {
      22,    36,    60,    98,    162,   267,   439,   720,   1179,  1921,  3108,
      4971,  7812,  11955, 17625, 24743, 32768, 40793, 47911, 53581, 57724, 60565,
      62428, 63615, 64357, 64816, 65097, 65269, 65374, 65438, 65476, 65500, 65514};
  const std::int32_t x = std::clamp(log_odds, -kLogOddsRange, kLogOddsRange) + 2048;
  const auto i = static_cast<std::size_t>(x >> 7);
  const std::int32_t share = x & 127;
  return (kSquashed[i] * (128 - share) + kSquashed[i + 1] * share + 64) >> 7;
}

/// The inverse of squash(), for the upper 12 bits of a probability.
extern const std::array<std::int16_t, 4096> kStretched;

/// The probability of a set bit in one context. It follows the bits that were coded: fast at first,
/// then more slowly.
struct AdaptiveBit {
  static constexpr std::uint16_t kSlowest = 250;

  std::uint16_t one = 32768;  // probability of a set bit, in 65536ths
  std::uint16_t seen = 0;     // number of bits seen, at most kSlowest

  void follow(bool bit);
};

/// For each number of bits that a context has seen: the rate at which its probability moves towards
/// the next bit, in 65536ths.
extern const std::array<std::int32_t, AdaptiveBit::kSlowest + 1> kRates;

inline void AdaptiveBit::follow(bool bit) {
  const std::int32_t target = bit ? 65535 : 0;
  const std::int64_t step = static_cast<std::int64_t>(target - one) * kRates[seen];
  one = static_cast<std::uint16_t>(one + (step >> 16));
  if (seen < kSlowest) ++seen;
}

/// The mixing weights of several contexts; 65536 stands for 1.0.
struct MixingWeights {
  static constexpr std::size_t kMost = 8;
  std::array<std::int32_t, kMost> of{};
};

/// Predicts one bit from several contexts, each of which has followed some of the earlier bits.
/// Every coded bit passes through here, so the code is inline and the number of contexts a template
/// argument.
template <std::size_t count, std::size_t opinion_count = 0>
class MixedBit {
 public:
  static constexpr std::size_t kAll = count + opinion_count;
  static_assert(kAll <= MixingWeights::kMost);

  /// `opinions` are log odds from other sources than contexts. Their weights come after those of
  /// the contexts.
  MixedBit(const std::array<AdaptiveBit*, count>& contexts, MixingWeights& weights,
           const std::array<std::int32_t, opinion_count>& opinions = {})
      : contexts_(contexts), weights_(weights) {
    for (std::size_t i = 0; i < count; ++i) evidence_[i] = kStretched[contexts[i]->one >> 4];
    std::copy(opinions.begin(), opinions.end(), evidence_.begin() + count);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < kAll; ++i)
      sum += static_cast<std::int64_t>(weights.of[i]) * evidence_[i];
    const auto log_odds = std::clamp<std::int64_t>(sum >> 16, -kLogOddsRange, kLogOddsRange);
    one_ = static_cast<Probability>(squash(static_cast<std::int32_t>(log_odds)));
  }

  Probability one() const { return one_; }

  /// Learning rates, as shifts. Weights that start from priors follow at kSlower.
  static constexpr int kSlow = 17;
  static constexpr int kSlower = 18;

  void follow(bool bit, int slowness = kSlow) {
    constexpr std::int32_t kRate = 3;
    constexpr std::int64_t kMost = 1 << 22;  // stands for 64.0; a bound, so that hostile bytes
                                             // cannot make a weight overflow
    const std::int32_t surprise = (bit ? 65536 : 0) - static_cast<std::int32_t>(one_);
    for (std::size_t i = 0; i < kAll; ++i) {
      // A change of the weight, before the shift; at most 2^16 * 2^11 * 3, so it cannot overflow.
      const std::int64_t step = static_cast<std::int64_t>(surprise) * evidence_[i] * kRate;
      const std::int64_t change = (step + (std::int64_t{1} << (slowness - 1))) >> slowness;
      weights_.of[i] = static_cast<std::int32_t>(
          std::clamp<std::int64_t>(weights_.of[i] + change, -kMost, kMost));
    }
    for (AdaptiveBit* const context : contexts_) context->follow(bit);
  }

 private:
  const std::array<AdaptiveBit*, count> contexts_;
  MixingWeights& weights_;
  std::array<std::int32_t, kAll> evidence_;  // log odds
  Probability one_;
};

}  // namespace mocapress::runtime
