// SPDX-License-Identifier: MIT
#include "core/select/end_weights.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(EndWeights, AreOneFarFromTheEndsAndMoreThere) {
  const Eigen::VectorXd weights = end_weights(200, 120);
  EXPECT_NEAR(weights(100), 1, 1e-9);
  EXPECT_GT(weights(0), 2);
  EXPECT_GT(weights(199), weights(0));
  EXPECT_GE(weights.minCoeff(), 1);
}

TEST(EndWeights, OfAnEndCountAsManySecondsAtEveryRate) {
  EXPECT_NEAR((end_weights(400, 120).array() - 1).sum() / 120,
              (end_weights(400, 30).array() - 1).sum() / 30, 1e-9);
}

TEST(EndWeights, ThereAreAsManyAsFrames) {
  for (const int frames : {0, 1, 2, 3}) EXPECT_EQ(end_weights(frames, 120).size(), frames);
}

}  // namespace
}  // namespace mocapress
