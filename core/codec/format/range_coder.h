// SPDX-License-Identifier: MIT
// Based on: G. N. N. Martin, "Range encoding", 1979; carry-free as in M. Mahoney, "Adaptive
// Weighing of Context Models for Lossless Data Compression", 2005.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/runtime/format/range_decoder.h"

namespace mocapress {

using runtime::kEvenOdds;
using runtime::Probability;

/// Codes bits for runtime::RangeDecoder, each in as many bits as its probability implies. Uses
/// integers only, so the bytes are the same everywhere.
class RangeEncoder {
 public:
  static constexpr bool kWrites = true;

  /// Returns the bit, so that one template serves writing and reading.
  bool code(bool bit, Probability probability_of_one);

  // Does nothing: a decoder refuses numbers out of bounds here, but written ones are always within
  // them.
  void refuse() {}
  static constexpr bool failed() { return false; }

  /// Returns the bytes; call after the last bit.
  std::vector<std::byte> finish();

 private:
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xFFFFFFFF;
  std::vector<std::byte> bytes_;
};

/// A RangeEncoder that decodes its own bytes at the end to check them. Each probability depends
/// only on earlier bits, so comparing the bits is enough.
class CheckedRangeEncoder {
 public:
  static constexpr bool kWrites = true;

  bool code(bool bit, Probability probability_of_one) {
    coded_.push_back(probability_of_one << 1 | static_cast<std::uint32_t>(bit));
    return encoder_.code(bit, probability_of_one);
  }

  void refuse() {}
  static constexpr bool failed() { return false; }

  /// Throws std::logic_error if the bytes decode to other bits.
  std::vector<std::byte> finish();

 private:
  RangeEncoder encoder_;
  std::vector<std::uint32_t> coded_;  // probability, bit
};

}  // namespace mocapress
