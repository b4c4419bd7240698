// SPDX-License-Identifier: MIT
#include "core/baselines/key_frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/baselines/cubic_spline.h"

namespace mocapress {
namespace {

Eigen::VectorXd chirp(int frames) {
  Eigen::VectorXd curve(frames);
  for (int t = 0; t < frames; ++t) curve(t) = 10 * std::sin(0.0004 * t * t);
  return curve;
}

TEST(KeyFrames, KeepTheSplineWithinTheTolerance) {
  const Eigen::VectorXd curve = chirp(600);
  std::size_t fewer = 0;
  for (const double tolerance : {5.0, 1.0, 0.1, 0.01}) {
    const std::vector<int> keys = choose_key_frames(curve, tolerance);
    EXPECT_LE((natural_spline(keys, curve(keys)) - curve).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_GT(keys.size(), fewer);
    fewer = keys.size();
  }
}

TEST(KeyFrames, StandWhereTheCurveMoves) {
  const std::vector<int> keys = choose_key_frames(chirp(600), 0.1);
  const auto early = std::count_if(keys.begin(), keys.end(), [](int key) { return key < 300; });
  EXPECT_GT(std::ssize(keys), 3 * early) << "the chirp is faster towards its end";
}

TEST(KeyFrames, RiseFromTheFirstFrameToTheLastWithoutLongGaps) {
  for (const int frames : {1, 2, 3, 256, 1000}) {
    const std::vector<int> keys = choose_key_frames(Eigen::VectorXd::Zero(frames), 1);
    EXPECT_EQ(keys.front(), 0);
    EXPECT_EQ(keys.back(), frames - 1);
    for (std::size_t i = 1; i < keys.size(); ++i) {
      EXPECT_GT(keys[i], keys[i - 1]);
      EXPECT_LE(keys[i] - keys[i - 1], kMostKeyGap);
    }
  }
}

TEST(KeyFrames, NoToleranceTakesEveryFrameOfNoise) {
  Eigen::VectorXd noise(40);
  for (int t = 0; t < 40; ++t) noise(t) = std::sin(1000.0 * t * t);
  EXPECT_EQ(choose_key_frames(noise, 0).size(), 40u);
}

}  // namespace
}  // namespace mocapress
