// SPDX-License-Identifier: MIT
// The errors that a file states, eps and max_error in CLIP, have 12 significant bits, so that a
// bank stores each in 16 bits: FORMAT.md, "Packed clips".
#pragma once

#include <cstdint>

#include "core/runtime/format/bit_pattern.h"

namespace mocapress::runtime {

inline constexpr int kErrorShift = 12;                     // low bits of the float, always zero
inline constexpr std::uint32_t kErrorOrigin = 106U << 11;  // 2^-21 cm
inline constexpr std::uint32_t kErrorHalf = 1U << (kErrorShift - 1);

inline float error_from(std::uint16_t code) {
  return code == 0 ? 0.0F : bit_pattern<float>((code + kErrorOrigin) << kErrorShift);
}

/// Finds the code of an error. False if it has none.
inline bool find_error_code(float error, std::uint16_t& code) {
  const auto bits = bit_pattern<std::uint32_t>(error);
  const std::uint32_t number = bits == 0 ? 0 : (bits >> kErrorShift) - kErrorOrigin;
  code = static_cast<std::uint16_t>(number);
  return number <= 0xFFFF && bit_pattern<std::uint32_t>(error_from(code)) == bits;
}

/// Rounds to the nearest value with 12 significant bits.
inline float rounded_error(float error) {
  const auto bits = bit_pattern<std::uint32_t>(error);
  if (bits >= 0x7F000000U) return error;  // huge, not a number, or negative
  return bit_pattern<float>((bits + kErrorHalf) >> kErrorShift << kErrorShift);
}

}  // namespace mocapress::runtime
