// SPDX-License-Identifier: MIT
#include "core/runtime/format/mixed_bit.h"

namespace mocapress::runtime {
namespace {

constexpr std::array<std::int16_t, 4096> stretch_table() {
  std::array<std::int16_t, 4096> table{};
  std::int32_t log_odds = -kLogOddsRange;
  for (std::size_t p = 0; p < table.size(); ++p) {
    while (log_odds < kLogOddsRange && squash(log_odds) < static_cast<std::int32_t>(16 * p + 8))
      ++log_odds;
    table[p] = static_cast<std::int16_t>(log_odds);
  }
  return table;
}

constexpr std::array<std::int32_t, AdaptiveBit::kSlowest + 1> rate_table() {
  std::array<std::int32_t, AdaptiveBit::kSlowest + 1> table{};
  for (std::int32_t n = 0; n <= AdaptiveBit::kSlowest; ++n)
    table[static_cast<std::size_t>(n)] = 65536 * 2 / (2 * n + 3);
  return table;
}

}  // namespace

constexpr std::array<std::int16_t, 4096> kStretched = stretch_table();
constexpr std::array<std::int32_t, AdaptiveBit::kSlowest + 1> kRates = rate_table();

}  // namespace mocapress::runtime
