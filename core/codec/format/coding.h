// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace mocapress {

/// The byte coding of chosen coefficients. The values are part of the file format.
enum class Coding : std::uint8_t {
  Rle16 = 1,     // 16-bit words with runs of zeros
  Deflate = 2,   // the same words, compressed together by DEFLATE
  Adaptive = 3,  // range coded, each bit predicted from earlier ones: adaptive.h
};

/// "rle16", "deflate", "adaptive".
std::string_view name(Coding coding);

/// Returns whether the coding uses words: all but Coding::Adaptive do.
constexpr bool uses_rle(Coding coding) {
  return coding != Coding::Adaptive;
}

}  // namespace mocapress
