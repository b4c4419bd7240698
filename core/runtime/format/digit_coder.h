// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/runtime/format/mixed_bit.h"
#include "core/runtime/format/range_decoder.h"

namespace mocapress::runtime {

/// Codes a bit by an adaptive probability of its own: FORMAT.md, 6.2. `Bits` as in
/// CoefficientCoder.
template <typename Bits>
bool code_bit(Bits& bits, AdaptiveBit& believed, bool bit) {
  constexpr Probability kLeast = 64;
  bit = bits.code(bit, std::clamp<Probability>(believed.one, kLeast, 65536 - kLeast));
  believed.follow(bit);
  return bit;
}

/// Codes non-negative integers: first the number of binary digits, then the digits. FORMAT.md,
/// ENDS.
class DigitCoder {
 public:
  static constexpr int kMostDigits = 24;  // a float holds integers of this many digits exactly

  template <typename Bits>
  std::int32_t code(Bits& bits, std::int32_t number) {
    const int wanted = std::bit_width(static_cast<std::uint32_t>(number));
    int digits = 0;
    while (digits < kMostDigits && code_bit(bits, has_more_[digits], digits < wanted)) ++digits;
    if (digits == 0) return 0;
    std::int32_t coded = 1;
    for (int d = digits - 2; d >= 0; --d)
      coded = 2 * coded + (bits.code((number >> d & 1) != 0, kEvenOdds) ? 1 : 0);
    return coded;
  }

 private:
  AdaptiveBit has_more_[kMostDigits];
};

}  // namespace mocapress::runtime
