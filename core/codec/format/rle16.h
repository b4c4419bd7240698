// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 4. FORMAT.md,
// MOTN.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/base/byte_cursor.h"

namespace mocapress {

/// No step is finer than 2 to this power: 8e-6 rad or cm, which is invisible.
inline constexpr double kFinestExponent = -17;

/// No step is coarser than 2 to this power, so that every sample is finite as a 32-bit float.
inline constexpr int kCoarsestExponent = 64;

/// Codes coefficients x channels (coarse to fine, zero where not kept) as 16-bit words with runs of
/// zeros and an end mark; values beyond 16 bits take 48. Each channel has one step, so scale the
/// coefficients by Lifting::gains() first, to make them matter equally. `dropped` is the magnitude
/// of each channel's largest dropped coefficient; a step is not made much finer than that.
std::vector<std::byte> rle16_encode(const Eigen::MatrixXd& coefficients,
                                    const Eigen::VectorXd& dropped);

/// The decoded words.
struct Rle16Values {
  std::vector<int> exponents;  // for each channel: its step is 2^exponent
  Eigen::MatrixXi values;      // coefficients x channels, in steps
};

/// Reads the next words: `channels` channels of `per_channel` coefficients. Throws FormatError.
Rle16Values rle16_read(ByteReader& reader, int per_channel, int channels);

/// The most bytes that a coding of this shape can take.
std::size_t rle16_bound(int per_channel, int channels);

}  // namespace mocapress
