// SPDX-License-Identifier: MIT
#include "core/codec/format/value_prediction.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/random.h"

namespace mocapress::runtime {
namespace {

std::int16_t noise(Random& random) {
  return static_cast<std::int16_t>(random.below(401) - 200);
}

TEST(RestPrediction, LearnsWhatTheLastTapSays) {
  Random random(5);
  RestPrediction rest;
  rest.begin();
  RestPrediction::Taps taps{};
  int off = 0;
  for (int i = 0; i < 4000; ++i) {
    taps.front() = noise(random);
    taps.back() = noise(random);
    const int value = -taps.back() / 2;
    const int error = value - rest.of(taps);
    if (i >= 3900) off += std::abs(error);
    rest.follow(taps, error);
  }
  EXPECT_LT(off / 100, 10);  // of 50 without a prediction
}

TEST(RestPrediction, StaysWithinBoundsWhateverComes) {
  RestPrediction rest;
  rest.begin();
  RestPrediction::Taps taps;
  taps.fill(SignalPrediction::kFarthest);
  for (int i = 0; i < 5000; ++i) rest.follow(taps, 5 * SignalPrediction::kFarthest);
  EXPECT_EQ(rest.of(taps), 2 * SignalPrediction::kFarthest);
  for (int i = 0; i < 10000; ++i) rest.follow(taps, -5 * SignalPrediction::kFarthest);
  EXPECT_EQ(rest.of(taps), -2 * SignalPrediction::kFarthest);
}

TEST(RestPrediction, LearnsNothingFromZeros) {
  RestPrediction rest;
  rest.begin();
  rest.follow(RestPrediction::Taps{}, 1000);
  for (const std::int32_t weight : rest.weights) EXPECT_EQ(weight, 0);
}

}  // namespace
}  // namespace mocapress::runtime
