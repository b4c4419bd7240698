// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress::runtime {

/// Replaces std::bit_cast, which the libc++ of some consoles and of WebAssembly lacks.
template <typename To, typename From>
constexpr To bit_pattern(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace mocapress::runtime
