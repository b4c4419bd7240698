// SPDX-License-Identifier: MIT
#include "core/base/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace mocapress {
namespace {

TEST(Random, GivesTheSameDrawsForTheSameSeed) {
  Random a(7);
  Random b(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.below(1000), b.below(1000));
}

TEST(Random, DrawsAreTheSameOnEveryPlatform) {
  Random random(
      1);  // mt19937_64's sequence is fixed by the standard; so is our way down to a range
  EXPECT_EQ(random.below(62), 2469588189546311528u % 62);
}

TEST(Random, BelowReachesEveryValueAboutEquallyOften) {
  Random random(3);
  std::vector<int> hits(10, 0);
  for (int i = 0; i < 10000; ++i) ++hits[random.below(10)];
  for (const int count : hits) EXPECT_NEAR(count, 1000, 150);
}

TEST(Random, UnitStaysInTheHalfOpenInterval) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.unit();
    EXPECT_GE(value, 0);
    EXPECT_LT(value, 1);
  }
}

}  // namespace
}  // namespace mocapress
