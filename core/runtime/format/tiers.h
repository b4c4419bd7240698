// SPDX-License-Identifier: MIT
// The tiers of a file: its first bytes alone give a coarser motion. See FORMAT.md, "TIER".
#pragma once

#include <cstdint>

#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kMostTiers = 8;
/// Largest size of a tier's entry in TIER: the size as a varint, bands and errors, and a checksum.
inline constexpr std::size_t kMostTierBytes = 5 + 5 + 4;

struct Tier {
  std::uint32_t bytes = 0;     // size of the piece that this tier adds; for the first tier, size of
                               // everything after TIER. 0 in a packed bank, which stores sizes
                               // elsewhere
  std::uint32_t checksum = 0;  // CRC-32 of that piece; 0 for the first tier, and in a packed bank
  int bands_left_out = 0;      // number of the finest bands that are missing in this tier
  float eps_cm = 0;            // errors of this tier; those of the last tier are in CLIP
  float max_error_cm = 0;
};

/// The section TIER.
struct TierTable {
  int count = 0;        // 0: the file has no tiers
  std::size_t end = 0;  // position in the file of the end of the section
  Tier tier[kMostTiers] = {};

  /// Number of bytes, from the start of the file, that a tier needs.
  std::size_t file_bytes(int number) const {
    std::size_t bytes = end;
    for (int t = 0; t <= number; ++t) bytes += tier[t].bytes;
    return bytes;
  }
};

/// Reads and checks the payload of TIER. In a packed bank, TIER has neither sizes nor checksums.
mcpr_result read_tiers(const Bytes& payload, TierTable& tiers, bool is_packed = false);

}  // namespace mocapress::runtime
