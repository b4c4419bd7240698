// SPDX-License-Identifier: MIT
// Adds entries one by one, for instruction sets whose vectors cannot look up weights.
#pragma once

#include <cstring>

#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Stores each weight at its row number modulo 16, and zeros elsewhere.
inline void place_weights(const std::int32_t* weights, int first_row, int shift,
                          std::int32_t* of_entry) {
  std::memset(of_entry, 0, 16 * sizeof *of_entry);
  for (int i = 0; i < kDetailWindow; ++i)
    of_entry[(first_row + i) & 15] =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(weights[i]) << shift);
}

/// Adds each entry, multiplied by the weight of its row, to the sum whose index is the lowest byte
/// of the entry.
inline void add_one_by_one(const EntryRun& run, const std::int32_t* weights, std::int32_t* sums) {
  constexpr unsigned kRowMask = (1U << kRowBits) - 1;
  for (int i = 0; i < run.count; ++i) {
    const unsigned bits = run.first[i];
    const std::int32_t value = static_cast<std::int16_t>(bits) >> (kColumnBits + kRowBits);
    std::int32_t& sum = sums[bits & 0xFF];
    sum = static_cast<std::int32_t>(
        static_cast<std::uint32_t>(sum) +
        static_cast<std::uint32_t>(weights[bits >> kColumnBits & kRowMask] * value));
  }
}

}  // namespace mocapress::runtime
