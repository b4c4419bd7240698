// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 4.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/format/coding.h"
#include "core/select/ranking.h"

namespace mocapress {

/// Codes the kept coefficients as words: MOTN in FORMAT.md. A signal's step is about half of the
/// largest coefficient that it drops. `scales` make signals comparable, as for StandardOrder.
std::vector<std::byte> code_signals(const RankedCoefficients& ranked,
                                    const std::vector<double>& scales, const Kept& kept);

/// The largest step of words that is at most `step`: a power of two.
double word_step(double step);

/// Codes coefficients, given in steps (one for each signal), as words.
std::vector<std::byte> code_steps(const Eigen::MatrixXi& values, const Eigen::VectorXd& steps);

/// The largest coefficient that each signal drops, times its gain. For a signal kept whole, a
/// quarter of the smallest value of the others.
Eigen::VectorXd largest_dropped(const RankedCoefficients& ranked, const std::vector<double>& scales,
                                const Kept& kept);

/// Convert words to bytes of a file, and back. Require uses_rle(coding). unpack() throws
/// FormatError for more than `most_bytes`.
std::vector<std::byte> pack(const std::vector<std::byte>& words, Coding coding);
std::vector<std::byte> unpack(std::span<const std::byte> bytes, Coding coding,
                              std::size_t most_bytes);

}  // namespace mocapress
