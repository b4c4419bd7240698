// SPDX-License-Identifier: MIT
#include "mixed_bit.h"

#include <algorithm>
#include <cassert>

namespace mocapress::decoder {
namespace {

constexpr int kLogOddsRange = 2047;  // -8 ... 8 in 256ths

// 65536 / (1 + exp(-x / 2)) for x = -16 ... 16.
constexpr std::array<std::int32_t, 33> kSquashed = {
    22,    36,    60,    98,    162,   267,   439,   720,   1179,  1921,  3108,
    4971,  7812,  11955, 17625, 24743, 32768, 40793, 47911, 53581, 57724, 60565,
    62428, 63615, 64357, 64816, 65097, 65269, 65374, 65438, 65476, 65500, 65514};

/// The probability (65536ths) of log odds (256ths).
constexpr std::int32_t squash(std::int32_t log_odds) {
  const std::int32_t x = std::clamp(log_odds, -kLogOddsRange, kLogOddsRange) + 2048;
  const auto i = static_cast<std::size_t>(x >> 7);
  const std::int32_t share = x & 127;
  return (kSquashed[i] * (128 - share) + kSquashed[i + 1] * share + 64) >> 7;
}

/// The inverse for the upper 12 bits of a probability.
constexpr std::array<std::int16_t, 4096> stretch_table() {
  std::array<std::int16_t, 4096> table{};
  std::int32_t log_odds = -kLogOddsRange;
  for (std::size_t p = 0; p < table.size(); ++p) {
    while (log_odds < kLogOddsRange && squash(log_odds) < static_cast<std::int32_t>(16 * p + 8))
      ++log_odds;
    table[p] = static_cast<std::int16_t>(log_odds);
  }
  return table;
}

constexpr std::array<std::int16_t, 4096> kStretched = stretch_table();

constexpr std::uint16_t kSlowest = 250;

constexpr std::array<std::int32_t, kSlowest + 1> rate_table() {
  std::array<std::int32_t, kSlowest + 1> table{};
  for (std::int32_t n = 0; n <= kSlowest; ++n)
    table[static_cast<std::size_t>(n)] = 65536 * 2 / (2 * n + 3);
  return table;
}

constexpr std::array<std::int32_t, kSlowest + 1> kRates = rate_table();

}  // namespace

std::uint16_t probability_of_log_odds(int log_odds) {
  return static_cast<std::uint16_t>(squash(log_odds));
}

void AdaptiveBit::follow(bool bit) {
  const std::int32_t target = bit ? 65535 : 0;
  const std::int64_t step = static_cast<std::int64_t>(target - one) * kRates[seen];
  one = static_cast<std::uint16_t>(one + (step >> 16));
  if (seen < kSlowest) ++seen;
}

MixedBit::MixedBit(std::span<AdaptiveBit* const> contexts, MixingWeights& weights)
    : contexts_(contexts), weights_(weights) {
  assert(contexts.size() <= MixingWeights::kMost);
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    evidence_[i] = kStretched[contexts[i]->one >> 4];
    sum += static_cast<std::int64_t>(weights.of[i]) * evidence_[i];
  }
  const auto log_odds = std::clamp<std::int64_t>(sum >> 16, -kLogOddsRange, kLogOddsRange);
  one_ = static_cast<Probability>(squash(static_cast<std::int32_t>(log_odds)));
}

void MixedBit::follow(bool bit) {
  constexpr std::int32_t kRate = 3;
  constexpr std::int64_t kMost = 1 << 22;  // 64: hostile bytes cannot overflow
  const std::int32_t surprise = (bit ? 65536 : 0) - static_cast<std::int32_t>(one_);
  for (std::size_t i = 0; i < contexts_.size(); ++i) {
    // 65536ths of weight; the product fits 64 bits by far.
    const std::int64_t step = static_cast<std::int64_t>(surprise) * evidence_[i] * kRate;
    const auto weight = weights_.of[i] + ((step + (1 << 16)) >> 17);
    weights_.of[i] = static_cast<std::int32_t>(std::clamp<std::int64_t>(weight, -kMost, kMost));
    contexts_[i]->follow(bit);
  }
}

}  // namespace mocapress::decoder
