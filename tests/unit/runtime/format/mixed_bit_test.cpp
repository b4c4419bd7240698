// SPDX-License-Identifier: MIT
#include "core/runtime/format/mixed_bit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace mocapress::runtime {
namespace {

MixingWeights even_weights() {
  MixingWeights weights;
  weights.of.fill(65536 * 4 / 10);
  return weights;
}

TEST(AdaptiveBit, ApproachesTheShareOfSetBits) {
  Random random(2);
  AdaptiveBit bit;
  for (int i = 0; i < 2000; ++i) bit.follow(random.below(10) == 0);
  EXPECT_NEAR(bit.one / 65536.0, 0.1, 0.04);
}

TEST(MixedBit, LearnsToTrustTheContextThatPredicts) {
  Random random(3);
  AdaptiveBit blind;
  AdaptiveBit knowing[2];
  MixingWeights weights = even_weights();
  double bits = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto hint = static_cast<std::size_t>(random.below(2));
    const bool bit = hint == 1 ? random.below(20) != 0 : random.below(20) == 0;
    const std::array contexts = {&blind, &knowing[hint]};
    MixedBit mixed(contexts, weights);
    const double one = mixed.one() / 65536.0;
    bits -= std::log2(bit ? one : 1 - one);
    mixed.follow(bit);
  }
  EXPECT_LT(bits / 4000, 0.32);  // 0.286 is the least there is
  EXPECT_GT(weights.of[1], weights.of[0]);
}

TEST(MixedBit, IsNeverCertain) {
  AdaptiveBit certain[MixingWeights::kMost];
  for (AdaptiveBit& bit : certain)
    for (int i = 0; i < 3000; ++i) bit.follow(true);
  std::array<AdaptiveBit*, MixingWeights::kMost> contexts;
  for (std::size_t i = 0; i < MixingWeights::kMost; ++i) contexts[i] = &certain[i];
  MixingWeights weights;
  weights.of.fill(1 << 22);
  EXPECT_LT(MixedBit(contexts, weights).one(), 65536u);
  weights.of.fill(-(1 << 22));
  EXPECT_GT(MixedBit(contexts, weights).one(), 0u);
}

TEST(LogOdds, AreSymmetric) {
  EXPECT_EQ(squash(0), 32768);
  for (int odds = 0; odds <= 2048; odds += 16) EXPECT_NEAR(squash(odds) + squash(-odds), 65536, 1);
}

}  // namespace
}  // namespace mocapress::runtime
