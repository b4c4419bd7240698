// SPDX-License-Identifier: MIT
#include "core/runtime/format/tiers.h"

#include "core/runtime/format/bands.h"
#include "core/runtime/format/coded_error.h"

namespace mocapress::runtime {

mcpr_result read_tiers(const Bytes& payload, TierTable& tiers, bool is_packed) {
  Cursor cursor = payload.cursor();
  const int count = cursor.read<std::uint8_t>();
  if (count < 2 || count > kMostTiers)
    return failure(MCPR_INVALID, payload.offset, "TIER has an impossible number of tiers");
  const std::size_t tier_bytes = is_packed ? kPackedTierBytes : kTierBytes;
  if (cursor.left() != tier_bytes * static_cast<std::size_t>(count))
    return failure(MCPR_INVALID, payload.offset, "TIER has the wrong size");
  std::uint32_t before = 0;
  for (int t = 0; t < count; ++t) {
    const std::size_t offset = cursor.offset();
    Tier& tier = tiers.tier[t];
    tier.file_bytes = is_packed ? before + 1 : cursor.read<std::uint32_t>();
    tier.bands_left_out = cursor.read<std::uint8_t>();
    tier.eps_cm = error_from(cursor.read<std::uint16_t>());
    tier.max_error_cm = error_from(cursor.read<std::uint16_t>());
    if (tier.file_bytes <= before ||
        (t > 0 && tier.bands_left_out >= tiers.tier[t - 1].bands_left_out) ||
        (tier.bands_left_out > 0) != (t < count - 1) || tier.bands_left_out >= kMostBands)
      return failure(MCPR_INVALID, offset, "TIER has tiers that do not follow each other");
    before = tier.file_bytes;
  }
  tiers.count = count;
  return kOk;
}

}  // namespace mocapress::runtime
