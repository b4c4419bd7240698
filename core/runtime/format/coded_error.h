// SPDX-License-Identifier: MIT
// Errors as a file states them (eps and max_error in CLIP). They are rounded to 12 significant
// bits, so that a bank can store each in 16 bits: FORMAT.md, "Packed clips".
#pragma once

#include <cstdint>

#include "core/runtime/format/bit_pattern.h"

namespace mocapress::runtime {

inline constexpr int kErrorShift = 12;  // lowest bits of a rounded float, always zero
// A code is the bits of a float above kErrorShift, less this. 2^-21 cm would have code 0.
inline constexpr std::uint32_t kErrorOrigin = 106U << 11;
inline constexpr std::uint32_t kErrorHalf = 1U << (kErrorShift - 1);

inline float error_from(std::uint16_t code) {
  return code == 0 ? 0.0F : bit_pattern<float>((code + kErrorOrigin) << kErrorShift);
}

/// Finds the 16-bit code of an error. Returns false if the error has none.
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
