// SPDX-License-Identifier: MIT
#include "resources/samples/generator/variation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mocapress::samples {
namespace {

TEST(Variation, DriftHasUnitRootMeanSquare) {
  Random random(5);
  const Drift drift(random);
  double squares = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) squares += std::pow(drift.at(i * 0.01), 2);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 1, 0.1);
}

TEST(Variation, SensorNoiseHasUnitDeviationAndNoMean) {
  Random random(6);
  double sum = 0;
  double squares = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const double noise = sensor_noise(random);
    sum += noise;
    squares += noise * noise;
  }
  EXPECT_NEAR(sum / kSamples, 0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 1, 0.03);
}

TEST(Variation, NoJointTremblesMoreThanMarkersDo) {
  for (const char* joint : {"root", "thorax", "head", "lhumerus", "rhand", "lfingers", "rthumb"}) {
    EXPECT_GE(unrest_of(joint).noise, 0.02) << joint;
    EXPECT_LE(unrest_of(joint).noise, 0.05) << joint;
  }
}

}  // namespace
}  // namespace mocapress::samples
