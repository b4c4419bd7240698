// SPDX-License-Identifier: MIT
// The finer tiers of a packed bank: FORMAT.md, "Tiers of a bank". They lie behind all else, tier by
// tier, so that a bank can be shipped, or loaded, without the finest.
#pragma once

#include "core/runtime/format/bank.h"

namespace mocapress::runtime {

class BankTiers {
 public:
  /// Reads the head of the tiers, which may be any bytes: see check().
  explicit BankTiers(const mcpk_bank& bank);

  /// Tiers of the bank, the first one included; 1: it has no others.
  int count() const { return count_; }

  /// Tiers that the bank still has: it may have been cut after any of them.
  int present() const { return present_; }

  /// The pieces of all clips in a tier, 1 <= tier < count().
  BankRegion region(int tier) const;

  /// The piece of a clip in a tier; without bytes if there is none.
  BankRegion piece(int tier, std::uint32_t clip) const;

  /// Checks where the pieces are, and with `pieces` the checksums of those that are present.
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

/// Size of the tables of a bank with this number of tiers, two or more.
constexpr std::uint64_t tier_table_bytes(std::uint64_t tiers, std::uint64_t clips) {
  return BankTiers::kHeadBytes +
         (tiers - 1) * (BankTiers::kRegionBytes + sizeof(std::uint32_t) * (clips + 1));
}

}  // namespace mocapress::runtime
