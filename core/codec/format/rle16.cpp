// SPDX-License-Identifier: MIT
#include "core/codec/format/rle16.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/byte_cursor.h"

namespace mocapress {
namespace {

using Word = std::int16_t;
constexpr int kRestIsZero = -32768;
constexpr int kLongestRun = 254;
constexpr int kWide = -32513;          // the coefficient follows in 32 bits
constexpr int kLargestNarrow = 32512;  // the largest that fits 16 bits; larger values are codes
constexpr double kLargestWide = 0x1p31 - 1;

/// The exponent of a channel's step. It need not be finer than half of the largest dropped
/// coefficient, since finer digits would be noise; and the largest coefficient must fit 32 bits.
int exponent_for(const Eigen::VectorXd& coefficients, double dropped) {
  const double largest = coefficients.size() == 0 ? 0 : coefficients.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  const double fits = std::ceil(std::log2(largest / kLargestWide));
  const double fine_enough = dropped > 0 ? std::floor(std::log2(dropped / 2)) : kFinestExponent;
  return static_cast<int>(std::clamp(std::max(fine_enough, fits), kFinestExponent,
                                     static_cast<double>(kCoarsestExponent)));
}

void write_value(ByteWriter& writer, std::int32_t value) {
  if (std::abs(value) <= kLargestNarrow) return writer.write(static_cast<Word>(value));
  writer.write(static_cast<Word>(kWide));
  writer.write(value);
}

void write_run(ByteWriter& writer, int zeros) {
  for (; zeros > 0; zeros -= kLongestRun)
    writer.write(static_cast<Word>(kRestIsZero + std::min(zeros, kLongestRun)));
}

void write_channel(ByteWriter& writer, const Eigen::VectorXd& coefficients, int exponent) {
  int zeros = 0;  // zeros not written yet, since they may be the end of the channel
  for (const double coefficient : coefficients) {
    const auto value = static_cast<std::int32_t>(std::lround(std::ldexp(coefficient, -exponent)));
    if (value == 0) {
      ++zeros;
      continue;
    }
    write_run(writer, zeros);
    zeros = 0;
    write_value(writer, value);
  }
  if (zeros > 0) writer.write(static_cast<Word>(kRestIsZero));
}

}  // namespace

std::vector<std::byte> rle16_encode(const Eigen::MatrixXd& coefficients,
                                    const Eigen::VectorXd& dropped) {
  ByteWriter writer;
  std::vector<int> exponents;
  for (Eigen::Index c = 0; c < coefficients.cols(); ++c) {
    exponents.push_back(exponent_for(coefficients.col(c), dropped(c)));
    writer.write(static_cast<std::int8_t>(exponents.back()));
  }
  for (Eigen::Index c = 0; c < coefficients.cols(); ++c)
    write_channel(writer, coefficients.col(c), exponents[c]);
  return writer.release();
}

Rle16Values rle16_read(ByteReader& reader, int per_channel, int channels) {
  Rle16Values read;
  for (int c = 0; c < channels; ++c) {
    read.exponents.push_back(reader.read<std::int8_t>());
    if (read.exponents.back() > kCoarsestExponent) reader.fail("a step is larger than 2^64");
  }
  read.values = Eigen::MatrixXi::Zero(per_channel, channels);
  for (int c = 0; c < channels; ++c) {
    int next = 0;
    while (next < per_channel) {
      const int word = reader.read<Word>();
      if (word == kRestIsZero) break;
      if (word >= kWide) {
        read.values(next++, c) = word == kWide ? reader.read<std::int32_t>() : word;
        continue;
      }
      next += word - kRestIsZero;
      if (next > per_channel) reader.fail("a run of zeros passes the end of its channel");
    }
  }
  return read;
}

std::size_t rle16_bound(int per_channel, int channels) {
  return static_cast<std::size_t>(channels) *
         (1 + sizeof(Word) * (3 * static_cast<std::size_t>(per_channel) + 1));
}

}  // namespace mocapress
