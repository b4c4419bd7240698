// SPDX-License-Identifier: MIT
// Based on: G. N. N. Martin, "Range encoding", 1979; carry-free as in M. Mahoney, "Adaptive
// Weighing of Context Models for Lossless Data Compression", 2005.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mocapress {

/// The probability of a set bit in 65536ths: 1 ... 65535.
using Probability = std::uint32_t;
inline constexpr Probability kEvenOdds = 32768;

/// Codes bits in as many bits as their probability asks for. Integers only: the same bytes
/// everywhere.
class RangeEncoder {
 public:
  void code(bool bit, Probability probability_of_one);

  /// The bytes, once every bit was coded.
  std::vector<std::byte> finish();

 private:
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xFFFFFFFF;
  std::vector<std::byte> bytes_;
};

/// The inverse, given the same probabilities. Any bytes decode to something; throws FormatError
/// when more bits are asked for than an encoder could have put into them, so that the work is
/// bounded by the number of bytes.
class RangeDecoder {
 public:
  /// `base_offset` is the place of the bytes in their file.
  explicit RangeDecoder(std::span<const std::byte> bytes, std::size_t base_offset = 0);

  bool code(Probability probability_of_one);

  /// Throws FormatError unless the bytes end where the encoder's did.
  void expect_end() const;

 private:
  void shift_in();

  std::span<const std::byte> bytes_;
  std::size_t base_offset_;
  std::size_t next_ = 0;  // beyond the end as soon as zeros are read there
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xFFFFFFFF;
  std::uint32_t code_ = 0;
};

}  // namespace mocapress
