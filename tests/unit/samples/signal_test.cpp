// SPDX-License-Identifier: MIT
#include "resources/samples/generator/signal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mocapress::samples {
namespace {

TEST(Signal, SmoothingTheLoweredStaysBelow) {
  const auto sawtooth = [](double t) { return std::fmod(t, 0.3) * 10; };
  const Signal original(0, 2, sawtooth);
  const Signal below = original.lowered(0.1).smoothed(0.1);
  for (double t = 0; t <= 2; t += 1.0 / 120) EXPECT_LE(below.at(t), original.at(t) + 1e-12);
}

TEST(Signal, SmoothingKeepsAStraightLineAwayFromTheEnds) {
  const Signal line = Signal(0, 2, [](double t) { return 3 * t - 1; }).smoothed(0.2);
  for (double t = 0.3; t < 1.7; t += 0.1) EXPECT_NEAR(line.at(t), 3 * t - 1, 1e-12);
}

}  // namespace
}  // namespace mocapress::samples
