// SPDX-License-Identifier: MIT
// The tiers of a file, whose first bytes alone give a coarser motion: FORMAT.md, "TIER".
#pragma once

#include <cstdint>

#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kMostTiers = 8;
/// The most bytes of a tier in TIER: its size as a varint, bands and errors, checksum.
inline constexpr std::size_t kMostTierBytes = 5 + 5 + 4;

struct Tier {
  std::uint32_t bytes = 0;  // size of what this tier adds to the one before; for the first tier, of
                            // all that follows TIER. 0 in a packed bank, which has it elsewhere
  std::uint32_t checksum = 0;  // CRC-32 of these bytes; 0 in the first, and in a packed bank
  int bands_left_out = 0;      // finest bands that this tier lacks
  float eps_cm = 0;            // this tier's; CLIP has those of the last tier
  float max_error_cm = 0;
};

/// The section TIER.
struct TierTable {
  int count = 0;        // 0: the file has no tiers
  std::size_t end = 0;  // where the section ends in the file
  Tier tier[kMostTiers] = {};

  /// The file's first bytes, which are enough for a tier.
  std::size_t file_bytes(int number) const {
    std::size_t bytes = end;
    for (int t = 0; t <= number; ++t) bytes += tier[t].bytes;
    return bytes;
  }
};

/// Reads and checks the payload of TIER. In a packed bank it has neither sizes nor checksums.
mcpr_result read_tiers(const Bytes& payload, TierTable& tiers, bool is_packed = false);

}  // namespace mocapress::runtime
