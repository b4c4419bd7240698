// SPDX-License-Identifier: MIT
// The tiers of a file, whose first bytes alone give a coarser motion: FORMAT.md, "TIER" and "FINE".
#pragma once

#include <cstdint>

#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kMostTiers = 8;
inline constexpr std::size_t kTierBytes = 9;  // of each in TIER, after their number in one byte
inline constexpr std::size_t kPackedTierBytes = 5;  // the same in a packed bank

struct Tier {
  std::uint32_t file_bytes =
      0;                   // size of the part of the file that this tier needs, from its start
  int bands_left_out = 0;  // finest bands that this tier lacks
  float eps_cm = 0;        // as in CLIP, of this tier
  float max_error_cm = 0;
};

/// The section TIER.
struct TierTable {
  int count = 0;  // 0: the file has no tiers
  Tier tier[kMostTiers] = {};
};

/// Reads and checks the payload of TIER. In a packed bank it has no file_bytes.
mcpr_result read_tiers(const Bytes& payload, TierTable& tiers, bool is_packed = false);

}  // namespace mocapress::runtime
