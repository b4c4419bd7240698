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

/// Codes bits for runtime::RangeDecoder, in as many bits as their probability asks for. Integers
/// only: the same bytes everywhere.
class RangeEncoder {
 public:
  static constexpr bool kWrites = true;

  /// Returns the bit: what a walk that is the same for writing and reading goes on with.
  bool code(bool bit, Probability probability_of_one);

  // Numbers that are written are within bounds.
  void refuse() {}
  static constexpr bool failed() { return false; }

  /// The bytes, once every bit was coded.
  std::vector<std::byte> finish();

 private:
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xFFFFFFFF;
  std::vector<std::byte> bytes_;
};

/// The same, and reads its bytes once they are there. What a bit is predicted from is what was
/// coded before it: where every bit comes back, so does all that they tell, which need not be
/// decoded to know it.
class CheckedRangeEncoder {
 public:
  static constexpr bool kWrites = true;

  bool code(bool bit, Probability probability_of_one) {
    coded_.push_back(probability_of_one << 1 | static_cast<std::uint32_t>(bit));
    return encoder_.code(bit, probability_of_one);
  }

  void refuse() {}
  static constexpr bool failed() { return false; }

  /// Throws std::logic_error where they do not say what was coded.
  std::vector<std::byte> finish();

 private:
  RangeEncoder encoder_;
  std::vector<std::uint32_t> coded_;  // probability, bit
};

}  // namespace mocapress
