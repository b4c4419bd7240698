// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace mocapress {

/// How chosen coefficients become bytes. The values are part of the file format.
enum class Coding : std::uint8_t {
  Rle16 = 1,     // 16-bit words with runs of zeros
  Deflate = 2,   // the same words, DEFLATE over all of them
  Adaptive = 3,  // range coded, each bit predicted from what was coded before: adaptive.h
};

/// "rle16", "deflate", "adaptive".
std::string_view name(Coding coding);

/// Words, as opposed to Coding::Adaptive.
constexpr bool uses_rle(Coding coding) {
  return coding != Coding::Adaptive;
}

}  // namespace mocapress
