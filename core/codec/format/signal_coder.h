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

/// The kept coefficients as words: MOTN in FORMAT.md. A signal's digits need not be finer than what
/// it drops. `scales` make signals comparable, as for StandardOrder.
std::vector<std::byte> code_signals(const RankedCoefficients& ranked,
                                    const std::vector<double>& scales, const Kept& kept);

/// The largest step of words that is not above `step`: a power of two.
double word_step(double step);

/// Coefficients in such steps (one for each signal) as words.
std::vector<std::byte> code_steps(const Eigen::MatrixXi& values, const Eigen::VectorXd& steps);

/// The largest coefficient each signal drops, times its gain. Of a signal that is kept whole: a
/// quarter of the least of the others.
Eigen::VectorXd largest_dropped(const RankedCoefficients& ranked, const std::vector<double>& scales,
                                const Kept& kept);

/// Words as bytes of a file, and back. Require uses_rle(coding). unpack() throws FormatError for
/// more than `most_bytes`.
std::vector<std::byte> pack(const std::vector<std::byte>& words, Coding coding);
std::vector<std::byte> unpack(std::span<const std::byte> bytes, Coding coding,
                              std::size_t most_bytes);

}  // namespace mocapress
