// SPDX-License-Identifier: MIT
#include "core/codec/format/rle16.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"

namespace mocapress {
namespace {

/// Mostly zero, with runs of every length and values over several orders of magnitude.
Eigen::MatrixXd sparse(int rows, int cols, double density, unsigned seed = 1) {
  Random random(seed);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, cols);
  for (double& value : matrix.reshaped())
    if (random.unit() < density) value = (random.unit() - 0.5) * std::exp(6 * random.unit());
  return matrix;
}

/// Nothing was dropped: the finest step.
std::vector<std::byte> encode(const Eigen::MatrixXd& matrix) {
  return rle16_encode(matrix, Eigen::VectorXd::Zero(matrix.cols()));
}

/// The coefficients of bytes that are nothing but these words.
Eigen::MatrixXd decode(std::span<const std::byte> bytes, int per_channel, int channels) {
  ByteReader reader(bytes);
  const Rle16Values read = rle16_read(reader, per_channel, channels);
  reader.expect_end();
  Eigen::MatrixXd coefficients = read.values.cast<double>();
  for (int c = 0; c < channels; ++c) coefficients.col(c) *= std::ldexp(1.0, read.exponents[c]);
  return coefficients;
}

TEST(Rle16, RestoresEveryShapeToTheFinestStep) {
  constexpr double kHalfStep = 0x1p-18;
  for (const int rows : {0, 1, 2, 253, 254, 255, 256, 700})
    for (const double density : {0.0, 0.003, 0.1, 1.0}) {
      const Eigen::MatrixXd matrix = sparse(rows, 5, density);
      const auto bytes = encode(matrix);
      EXPECT_LE(bytes.size(), rle16_bound(rows, 5));
      const Eigen::MatrixXd error = decode(bytes, rows, 5) - matrix;
      EXPECT_LE(error.size() == 0 ? 0 : error.cwiseAbs().maxCoeff(), kHalfStep);
    }
}

TEST(Rle16, KeepsSmallValuesBesideVeryLargeOnes) {
  Eigen::MatrixXd matrix(3, 1);
  matrix << 60000, 0.5, -3000;  // a root far away and turned many times
  const Eigen::MatrixXd restored =
      decode(rle16_encode(matrix, Eigen::VectorXd::Constant(1, 0.002)), 3, 1);
  EXPECT_LE((restored - matrix).cwiseAbs().maxCoeff(), 0.0005);
}

TEST(Rle16, RefusesStepsOfWhichSamplesWouldNotBeFinite) {
  std::vector<std::byte> bytes = encode(sparse(20, 1, 1));
  for (const int exponent : {kCoarsestExponent, kCoarsestExponent + 1, 127}) {
    bytes.front() = static_cast<std::byte>(exponent);
    if (exponent == kCoarsestExponent)
      EXPECT_TRUE(decode(bytes, 20, 1).cast<float>().allFinite());
    else
      EXPECT_THROW(decode(bytes, 20, 1), FormatError);
  }
}

TEST(Rle16, RoundsToHalfOfWhatWasDroppedAtMost) {
  const Eigen::MatrixXd matrix = sparse(300, 1, 0.3);
  for (const double dropped : {0.01, 0.3, 2.0}) {
    const auto bytes = rle16_encode(matrix, Eigen::VectorXd::Constant(1, dropped));
    const Eigen::MatrixXd error = decode(bytes, 300, 1) - matrix;
    EXPECT_LE(error.cwiseAbs().maxCoeff(), dropped / 4);
    EXPECT_GT(error.cwiseAbs().maxCoeff(), dropped / 32);
  }
}

TEST(Rle16, KeepsZerosZero) {
  const Eigen::MatrixXd matrix = sparse(500, 3, 0.05);
  const Eigen::MatrixXd restored = decode(encode(matrix), 500, 3);
  for (Eigen::Index i = 0; i < matrix.size(); ++i)
    EXPECT_TRUE(matrix.reshaped()(i) != 0 || restored.reshaped()(i) == 0);
}

TEST(Rle16, SpendsThreeBytesOnAnEmptyChannel) {
  EXPECT_EQ(encode(Eigen::MatrixXd::Zero(5000, 4)).size(), 4u * 3u);
}

TEST(Rle16, WritesTheBytesOfTheFormat) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, 1);
  matrix(0, 0) = 2;
  matrix(3, 0) = -2;  // after a run of two zeros
  const std::vector<std::byte> expected = {std::byte{0},    std::byte{2},    std::byte{0},
                                           std::byte{2},    std::byte{0x80}, std::byte{0xFE},
                                           std::byte{0xFF}, std::byte{0},    std::byte{0x80}};
  // Half of a dropped 2 is a step of 1, exponent 0.
  EXPECT_EQ(rle16_encode(matrix, Eigen::VectorXd::Constant(1, 2.0)), expected);
}

TEST(Rle16, RefusesEveryPrefixAndEveryExtraByte) {
  const auto bytes = encode(sparse(60, 4, 0.2));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::byte> prefix(bytes.begin(), bytes.begin() + static_cast<long>(size));
    EXPECT_THROW(decode(prefix, 60, 4), FormatError) << size;
  }
  auto longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_THROW(decode(longer, 60, 4), FormatError);
}

TEST(Rle16, RefusesARunPastTheEndOfItsChannel) {
  const std::vector<std::byte> bytes = {std::byte{0}, std::byte{7}, std::byte{0x80}};
  EXPECT_NO_THROW(decode(bytes, 7, 1));
  EXPECT_THROW(decode(bytes, 6, 1), FormatError);
}

TEST(Rle16, SurvivesArbitraryBytes) {
  Random random(8);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::byte> bytes(random.below(80));
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
    try {
      EXPECT_EQ(decode(bytes, 9, 3).size(), 27);
    } catch (const FormatError&) {
    }
  }
}

}  // namespace
}  // namespace mocapress
