// SPDX-License-Identifier: MIT
#include "core/runtime/format/bank_tiers.h"

#include "core/runtime/format/tiers.h"

namespace mocapress::runtime {

BankTiers::BankTiers(const mcpk_bank& bank) : bank_(bank), tables_(bank.bytes_of(bank.tables)) {
  if (bank.is_cooked()) return;
  const auto count = tables_.cursor().read<std::uint32_t>();
  if (count < 2 || count > kMostTiers || tables_.size != tier_table_bytes(count, bank.clips))
    return;
  count_ = static_cast<int>(count);
  while (present_ < count_) {
    const BankRegion next = region(present_);
    if (next.offset > bank.bytes || next.bytes > bank.bytes - next.offset) break;
    ++present_;
  }
}

Bytes BankTiers::head_of(int tier) const {
  const std::size_t at = kHeadBytes + kRegionBytes * static_cast<std::size_t>(tier - 1);
  return {tables_.data + at, kRegionBytes, tables_.offset + at};
}

BankRegion BankTiers::region(int tier) const {
  Cursor head = head_of(tier).cursor();
  const auto offset = head.read<std::uint64_t>();
  return {offset, head.read<std::uint64_t>()};
}

std::uint32_t BankTiers::begin(int tier, std::uint32_t clip) const {
  const auto before = static_cast<std::size_t>(tier - 1) * (std::size_t{bank_.clips} + 1) + clip;
  const std::size_t at = kHeadBytes + kRegionBytes * static_cast<std::size_t>(count_ - 1);
  std::uint32_t begin = 0;
  std::memcpy(&begin, tables_.data + at + sizeof begin * before, sizeof begin);
  return begin;
}

BankRegion BankTiers::piece(int tier, std::uint32_t clip) const {
  if (tier < 1 || tier >= count_ || clip >= bank_.clips) return {};
  const BankRegion all = region(tier);
  const std::uint32_t first = begin(tier, clip);
  const std::uint32_t end = begin(tier, clip + 1);
  if (first > end || end > all.bytes) return {};
  return {all.offset + first, std::uint64_t{end} - first};
}

mcpr_result BankTiers::check(bool pieces) const {
  const auto refuse = [&] {
    return failure(MCPR_INVALID, tables_.offset, "the tiers of the bank make no sense");
  };
  std::uint64_t end = bank_.tables.offset + bank_.tables.bytes;
  if (count_ == 1)
    return bank_.is_cooked() || (tables_.size == 0 && bank_.bytes == end) ? kOk : refuse();
  bool ends_here = bank_.bytes == end;
  for (int tier = 1; tier < count_; ++tier) {
    const BankRegion all = region(tier);
    if (all.offset != end || all.bytes > 0xFFFFFFFFU) return refuse();
    end += all.bytes;
    ends_here = ends_here || bank_.bytes == end;
    if (begin(tier, 0) != 0 || begin(tier, bank_.clips) != all.bytes) return refuse();
    for (std::uint32_t clip = 0; clip < bank_.clips; ++clip)
      if (begin(tier, clip) > begin(tier, clip + 1)) return refuse();
    if (!pieces || tier >= present_) continue;
    std::uint32_t checksum = 0;
    std::memcpy(&checksum, head_of(tier).data + 16, sizeof checksum);
    if (bank_checksum(bank_.at(all.offset), static_cast<std::size_t>(all.bytes)) != checksum)
      return failure(MCPR_DAMAGED, static_cast<std::size_t>(all.offset),
                     "a tier of the bank is damaged: its checksum differs");
  }
  return ends_here ? kOk : refuse();
}

}  // namespace mocapress::runtime
