// SPDX-License-Identifier: MIT
#include "core/runtime/format/value_prediction.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/random.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::runtime {
namespace {

std::int16_t noise(Random& random) {
  return static_cast<std::int16_t>(random.below(401) - 200);
}

TEST(RestPrediction, LearnsFromTheLastTap) {
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
  EXPECT_LT(off / 100, 10);  // 50 without a prediction
}

TEST(RestPrediction, StaysWithinBoundsForAnyInput) {
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

/// Realistic values: many zeros, and some as large as a file can hold.
std::int32_t any_value(Random& random) {
  switch (random.below(8)) {
    case 0:
      return static_cast<std::int32_t>(random.below(1 << 29)) - (1 << 28);
    case 1:
    case 2:
    case 3:
      return 0;
    default:
      return static_cast<std::int32_t>(random.below(41)) - 20;
  }
}

void expect_plain_numbers_from(const PredictionKernels& best) {
  Random random(9);
  SignalPrediction plain_signal;
  RestPrediction plain_rest;
  plain_signal.begin();
  plain_rest.begin();
  SignalPrediction signal = plain_signal;
  RestPrediction rest = plain_rest;
  for (int i = 0; i < 20000; ++i) {
    const bool is_zero = random.below(50) == 0;
    std::array<std::int32_t, RestPrediction::kTaps> values;
    for (std::int32_t& value : values) value = is_zero ? 0 : any_value(random);
    const std::int32_t inverse = kInverseScales[random.below(kScales)];
    RestPrediction::Taps plain_taps;
    RestPrediction::Taps taps;
    kPlainPrediction.normalise(values, inverse, plain_taps);
    best.normalise(values, inverse, taps);
    ASSERT_EQ(taps, plain_taps) << i;
    const int first = kPlainPrediction.of_signal(plain_signal, taps.data());
    const int second = kPlainPrediction.of_rest(plain_rest, taps);
    ASSERT_EQ(best.of_signal(signal, taps.data()), first) << i;
    ASSERT_EQ(best.of_rest(rest, taps), second) << i;
    const int error = normalised(any_value(random), inverse) - first;
    kPlainPrediction.signal_follows(plain_signal, taps.data(), error);
    best.signal_follows(signal, taps.data(), error);
    kPlainPrediction.rest_follows(plain_rest, taps, error - second);
    best.rest_follows(rest, taps, error - second);
    ASSERT_EQ(signal.products, plain_signal.products) << i;
    ASSERT_EQ(signal.errors, plain_signal.errors) << i;
    ASSERT_EQ(signal.weights, plain_signal.weights) << i;
    ASSERT_EQ(rest.weights, plain_rest.weights) << i;
  }
}

TEST(PredictionKernels, AgreeInEveryInstructionSet) {
  for (const mcpr_path path : existing_paths()) expect_plain_numbers_from(*prediction_of(path));
}

TEST(PredictionKernels, NormaliseAs64BitProductsWould) {
  Random random(10);
  for (int i = 0; i < 100000; ++i) {
    const std::int32_t value = any_value(random);
    const std::int32_t inverse = kInverseScales[random.below(kScales)];
    EXPECT_EQ(normalised(value, inverse),
              std::clamp<std::int64_t>(static_cast<std::int64_t>(value) * inverse >> 10,
                                       -SignalPrediction::kFarthest, SignalPrediction::kFarthest))
        << value << " " << inverse;
  }
}

}  // namespace
}  // namespace mocapress::runtime
