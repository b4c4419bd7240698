// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/select/ranking.h"

namespace mocapress {

/// How chosen coefficients become bytes. The values are part of the file format.
enum class Coding : std::uint8_t {
  Rle16 = 1,    // 16-bit words with runs of zeros
  Deflate = 2,  // the same words, DEFLATE over all of them
};

/// "rle16", "deflate".
std::string_view name(Coding coding);

/// The kept coefficients as bytes: MOTN in FORMAT.md. A signal's digits need not be finer than what
/// it drops.
std::vector<std::byte> code_signals(const RankedCoefficients& ranked, const Kept& kept,
                                    Coding coding);

/// The signals again, samples x count. Throws FormatError when the bytes are not valid.
Eigen::MatrixXd decode_signals(std::span<const std::byte> bytes, Basis basis, Coding coding,
                               int samples, int count);

}  // namespace mocapress
