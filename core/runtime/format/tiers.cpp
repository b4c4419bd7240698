// SPDX-License-Identifier: MIT
#include "core/runtime/format/tiers.h"

#include "core/runtime/format/bands.h"
#include "core/runtime/format/coded_error.h"
#include "core/runtime/format/cursor.h"

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kMostBytes = 0xFFFFFFFFU;  // limit for a tier, and for a whole file with
                                                   // tiers
constexpr std::size_t kMostBytesOfSize = 5;

}  // namespace

mcpr_result read_tiers(const Bytes& payload, TierTable& tiers, bool is_packed) {
  Cursor cursor = payload.cursor();
  const int count = cursor.read<std::uint8_t>();
  if (count < 2 || count > kMostTiers)
    return failure(MCPR_INVALID, payload.offset, "TIER has an impossible number of tiers");
  std::uint64_t all = payload.offset + payload.size;
  for (int t = 0; t < count; ++t) {
    const std::size_t offset = cursor.offset();
    const bool is_last = t == count - 1;
    Tier& tier = tiers.tier[t];
    const std::uint64_t bytes = is_packed ? 0 : cursor.read_varint();
    const bool is_long = cursor.offset() - offset > kMostBytesOfSize;
    if (!is_packed && t > 0) tier.checksum = cursor.read<std::uint32_t>();
    if (!is_last) {
      tier.bands_left_out = cursor.read<std::uint8_t>();
      tier.eps_cm = error_from(cursor.read<std::uint16_t>());
      tier.max_error_cm = error_from(cursor.read<std::uint16_t>());
    }
    if (cursor.failed()) return failure(MCPR_INVALID, offset, "TIER is too short");
    if ((bytes == 0) != is_packed || is_long || bytes > kMostBytes || (all += bytes) > kMostBytes ||
        (t > 0 && tier.bands_left_out >= tiers.tier[t - 1].bands_left_out) ||
        (tier.bands_left_out > 0) == is_last || tier.bands_left_out >= kMostBands)
      return failure(MCPR_INVALID, offset, "TIER has tiers that do not follow each other");
    tier.bytes = static_cast<std::uint32_t>(bytes);
  }
  if (cursor.left() > 0) return failure(MCPR_INVALID, cursor.offset(), "TIER has the wrong size");
  tiers.count = count;
  tiers.end = payload.offset + payload.size;
  return kOk;
}

}  // namespace mocapress::runtime
