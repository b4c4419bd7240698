// SPDX-License-Identifier: MIT
#include "core/metrics/distance_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"

namespace mocapress {
namespace {

TEST(DistanceCounts, GivePercentilesToTheirPrecisionAndNeverMore) {
  Random random(1);
  for (const double spread : {0.1, 2.0, 12.0}) {
    std::vector<float> distances;
    DistanceCounts counts;
    for (int i = 0; i < 10'000; ++i) {
      distances.push_back(static_cast<float>(0.3 * std::exp(spread * (random.unit() - 0.5))));
      counts.add(distances.back());
    }
    std::sort(distances.begin(), distances.end());
    for (const double share : {0.0, 0.001, 0.5, 0.95, 0.99, 1.0}) {
      const auto rank = std::max(1.0, std::ceil(share * 10'000));
      const auto exact = static_cast<double>(distances[static_cast<std::size_t>(rank) - 1]);
      EXPECT_LE(counts.percentile(share), exact) << share;
      EXPECT_GT(counts.percentile(share), (1 - DistanceCounts::kPrecision) * exact) << share;
    }
  }
}

TEST(DistanceCounts, ZeroAndNoneAreZero) {
  DistanceCounts counts;
  EXPECT_EQ(counts.percentile(0.95), 0);
  for (int i = 0; i < 99; ++i) counts.add(0);
  counts.add(7);
  EXPECT_EQ(counts.percentile(0.99), 0);
  EXPECT_EQ(counts.percentile(1), 7);
}

TEST(DistanceCounts, WhatIsNoNumberIsLargerThanAnyDistance) {
  DistanceCounts counts;
  counts.add(1);
  for (const float sign : {1.0F, -1.0F})
    counts.add(std::copysign(std::numeric_limits<float>::quiet_NaN(), sign));
  EXPECT_EQ(counts.percentile(0.3), 1);
  EXPECT_FALSE(counts.percentile(1) < std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mocapress
