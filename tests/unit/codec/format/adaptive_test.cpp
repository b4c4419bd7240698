// SPDX-License-Identifier: MIT
#include "core/codec/format/adaptive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

const std::vector<SignalNeighbours>& neighbours() {
  static const std::vector<SignalNeighbours> of_figure = [] {
    std::vector<SignalNeighbours> all = channel_neighbours(test::small_skeleton());
    append_correction_neighbours(6, all);
    return all;
  }();
  return of_figure;
}

/// Sparse, with values over several orders of magnitude.
QuantisedSignals random_signals(int length, double density, std::uint64_t seed = 1) {
  Random random(seed);
  QuantisedSignals coded{.scale = file_scale(0.3)};
  coded.values.setZero(length, std::ssize(neighbours()));
  for (int& value : coded.values.reshaped())
    if (random.unit() < density)
      value = static_cast<int>((random.unit() - 0.5) * std::exp(12 * random.unit()));
  for (std::size_t s = 0; s < neighbours().size(); ++s)
    coded.step_exponent.push_back(static_cast<int>(random.below(40)) - 12);
  return coded;
}

void expect_same(const QuantisedSignals& a, const QuantisedSignals& b) {
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.step_exponent, b.step_exponent);
  EXPECT_EQ(a.values, b.values);
}

TEST(Adaptive, RestoresEveryLengthAndDensity) {
  for (const int length : {0, 1, 2, 3, 4, 5, 9, 64, 131})
    for (const double density : {0.0, 0.01, 0.2, 1.0}) {
      const QuantisedSignals coded = random_signals(length, density);
      const auto bytes = adaptive_encode(coded, neighbours());
      expect_same(adaptive_decode(bytes, neighbours(), length), coded);
    }
}

TEST(Adaptive, RestoresTheLargestValues) {
  QuantisedSignals coded = random_signals(40, 0.3);
  coded.values(0, 0) = kMostSteps;
  coded.values(1, 0) = -kMostSteps;
  coded.values(39, 3) = -kMostSteps;
  coded.step_exponent.front() = kMostStepExponent;
  coded.step_exponent.back() = kLeastStepExponent;
  expect_same(adaptive_decode(adaptive_encode(coded, neighbours()), neighbours(), 40), coded);
}

TEST(Adaptive, StaticSignalsCostNextToNothing) {
  QuantisedSignals coded = random_signals(4096, 0);
  for (int& step_exponent : coded.step_exponent) step_exponent = 0;
  EXPECT_LT(adaptive_encode(coded, neighbours()).size(), 2 + 4 * neighbours().size());
  const QuantisedSignals moving = random_signals(4096, 0.1);
  coded.values.col(5) = moving.values.col(5);
  const auto one = adaptive_encode(coded, neighbours()).size();
  const auto all = adaptive_encode(moving, neighbours()).size();
  EXPECT_LT(static_cast<double>(one),
            1.5 * static_cast<double>(all) / static_cast<double>(neighbours().size()));
}

TEST(Adaptive, LearnsWhatRepeats) {
  QuantisedSignals coded = random_signals(512, 0);
  const auto silent = adaptive_encode(coded, neighbours()).size();
  for (Eigen::Index s = 0; s < coded.values.cols(); ++s)
    for (int c = 256; c < 512; c += 8) coded.values(c, s) = 1;
  const double bits =
      8.0 * static_cast<double>(adaptive_encode(coded, neighbours()).size() - silent);
  EXPECT_LT(bits / static_cast<double>(coded.values.cwiseAbs().sum()), 5);
}

TEST(Adaptive, EveryTruncationIsRefusedOrDecodes) {
  const auto bytes = adaptive_encode(random_signals(60, 0.2), neighbours());
  int refused = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    try {
      adaptive_decode(std::span(bytes).first(size), neighbours(), 60);
    } catch (const FormatError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(bytes.size()) / 2);
}

TEST(Adaptive, CorruptBytesAreRefusedOrDecodeWithinBounds) {
  const auto bytes = adaptive_encode(random_signals(60, 0.2), neighbours());
  Random random(9);
  for (int trial = 0; trial < 300; ++trial) {
    auto damaged = bytes;
    for (int hit = 0; hit < 1 + trial % 5; ++hit)
      damaged[random.below(damaged.size())] ^= static_cast<std::byte>(1 + random.below(255));
    try {
      const QuantisedSignals decoded = adaptive_decode(damaged, neighbours(), 60);
      EXPECT_LE(decoded.values.cwiseAbs().maxCoeff(), kMostSteps);
      EXPECT_GT(decoded.scale, 0);
    } catch (const FormatError&) {
    }
  }
}

TEST(Adaptive, RefusesAnInvalidScale) {
  auto bytes = adaptive_encode(random_signals(20, 0.2), neighbours());
  for (const int high : {0x00, 0x7F, 0xBF}) {  // zero, not finite, negative
    bytes[0] = static_cast<std::byte>(high == 0 ? 0 : 0xC0);
    bytes[1] = static_cast<std::byte>(high);
    EXPECT_THROW(adaptive_decode(bytes, neighbours(), 20), FormatError);
  }
}

TEST(SignalNeighbours, PointsBackwards) {
  for (int s = 0; s < static_cast<int>(neighbours().size()); ++s) {
    EXPECT_LT(neighbours()[static_cast<std::size_t>(s)].sibling, s);
    EXPECT_LT(neighbours()[static_cast<std::size_t>(s)].mirror, s);
  }
}

}  // namespace
}  // namespace mocapress
