// SPDX-License-Identifier: MIT
// The finer tiers of a packed bank: FORMAT.md, "Tiers of a bank". They come last in the bank, tier
// by tier, so that a bank can be shipped or loaded without its finest tiers.
#pragma once

#include "core/runtime/format/bank.h"

namespace mocapress::runtime {

class BankTiers {
 public:
  /// Reads the head of the tiers. The bytes may be damaged: check() verifies them.
  explicit BankTiers(const mcpk_bank& bank);

  /// Tiers of the bank, the first one included; 1: it has no others.
  int count() const { return count_; }

  /// Number of tiers that are complete: a bank may be cut short after any tier.
  int present() const { return present_; }

  /// The bytes of a tier, with the pieces of all clips. 1 <= tier < count().
  BankRegion region(int tier) const;

  /// The bytes that a tier adds to a clip; empty if the clip has no such tier.
  BankRegion piece(int tier, std::uint32_t clip) const;

  /// Checks the positions of the pieces and, with `pieces`, the checksums of all tiers that are
  /// present.
  mcpr_result check(bool pieces) const;

  static constexpr std::size_t kHeadBytes = 4;     // u32 tiers
  static constexpr std::size_t kRegionBytes = 20;  // u64 offset, u64 bytes, u32 checksum

 private:
  Bytes head_of(int tier) const;
  std::uint32_t begin(int tier, std::uint32_t clip) const;

  const mcpk_bank& bank_;
  Bytes tables_;
  int count_ = 1;
  int present_ = 1;
};

/// Size of the tables in the bank's head of tiers. `tiers` is two or more.
constexpr std::uint64_t tier_table_bytes(std::uint64_t tiers, std::uint64_t clips) {
  return BankTiers::kHeadBytes +
         (tiers - 1) * (BankTiers::kRegionBytes + sizeof(std::uint32_t) * (clips + 1));
}

}  // namespace mocapress::runtime
