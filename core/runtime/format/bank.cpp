// SPDX-License-Identifier: MIT
#include "core/runtime/format/bank.h"

#include <algorithm>

namespace mocapress::runtime {
namespace {

constexpr std::uint64_t kMostRegion = 0xFFFFFFFFU;  // offsets within a region are stored in 32 bits

std::uint64_t aligned_in(const mcpk_bank& bank, std::uint64_t offset) {
  return bank.is_cooked() ? (offset + kCookedAlignment - 1) / kCookedAlignment * kCookedAlignment
                          : offset;
}

bool lies_within(const BankRegion& region, std::uint64_t bytes) {
  return region.offset >= sizeof(mcpk_bank) && region.offset <= bytes &&
         region.bytes <= bytes - region.offset && region.bytes <= kMostRegion;
}

}  // namespace

std::uint32_t bank_checksum(const void* bytes, std::size_t size) {
  return crc32(static_cast<const std::uint8_t*>(bytes), size);
}

mcpr_result check_bank_head(const mcpk_bank& bank, std::size_t size) {
  if (size < sizeof bank)
    return std::memcmp(bank.magic, mcpk_bank::kMagic, std::min(size, sizeof bank.magic)) != 0
               ? failure(MCPR_NOT_A_CLIP, 0, "not a bank of clips")
               : failure(MCPR_DAMAGED, size, "the bank is cut short");
  if (std::memcmp(bank.magic, mcpk_bank::kMagic, sizeof bank.magic) != 0)
    return failure(MCPR_NOT_A_CLIP, 0, "not a bank of clips");
  if (bank.version != mcpk_bank::kVersion)
    return failure(MCPR_UNKNOWN_VERSION, offsetof(mcpk_bank, version),
                   "the version is unknown: a newer Mocapress is needed");
  if (bank_checksum(&bank, offsetof(mcpk_bank, checksum)) != bank.checksum)
    return failure(MCPR_DAMAGED, 0, "the head of the bank is damaged: its checksum differs");
  if (bank.bytes > size)
    return failure(MCPR_DAMAGED, offsetof(mcpk_bank, bytes), "the bank is cut short");
  if (bank.form > BankForm::Cooked)
    return failure(MCPR_INVALID, offsetof(mcpk_bank, form), "an unknown form of bank");
  std::uint64_t items = 0;
  for (const std::uint32_t count : bank.item_counts) items += count;
  const bool possible = bank.clips <= kMostClipsOfBank && lies_within(bank.index, bank.bytes) &&
                        lies_within(bank.items, bank.bytes) &&
                        lies_within(bank.tables, bank.bytes) &&
                        bank.tables.offset % kCookedAlignment == 0 && bank.items.offset % 4 == 0 &&
                        kBlockBytes * std::uint64_t{bank.blocks()} <= bank.index.bytes &&
                        4 * (items + 1) <= bank.items.bytes && bank.count(BankItem::Text) % 2 == 0;
  return possible ? kOk : failure(MCPR_INVALID, 0, "the bank has an impossible head");
}

EntryWalk::EntryWalk(const mcpk_bank& bank, std::uint32_t block)
    : bank_(bank), cursor_(nullptr, 0) {
  if (block >= bank.blocks()) return;
  const Bytes index = bank.bytes_of(bank.index);
  std::uint32_t entry = 0;
  std::memcpy(&data_, index.data + kBlockBytes * block, sizeof data_);
  std::memcpy(&entry, index.data + kBlockBytes * block + sizeof data_, sizeof entry);
  std::memcpy(&checksum_, index.data + kBlockBytes * block + sizeof data_ + sizeof entry,
              sizeof checksum_);
  if (entry > index.size) return;
  cursor_ = {index.data + entry, index.size - entry, index.offset + entry};
  number_ = kClipsOfBlock * block;
  left_ = std::min(kClipsOfBlock, bank.clips - number_);
}

bool EntryWalk::next(BankEntry& entry) {
  if (left_ == 0) return false;
  --left_;
  if (is_first_) entry.name_length = 0;
  const unsigned head = cursor_.read<std::uint8_t>();
  const std::uint64_t dropped = name_part(head);
  const std::uint64_t length = name_part(head >> kNewNameShift) + 1;
  if (dropped > entry.name_length || length > kMostNameOfClip + dropped - entry.name_length)
    return false;
  const std::size_t kept = entry.name_length - static_cast<std::size_t>(dropped);
  const std::uint8_t* const name = cursor_.take(static_cast<std::size_t>(length));
  if (name == nullptr || (is_first_ && (head & (kHasKind | kHasTags)) != (kHasKind | kHasTags)))
    return false;
  is_first_ = false;
  std::memcpy(entry.name + kept, name, static_cast<std::size_t>(length));
  entry.name_length = static_cast<std::uint8_t>(kept + length);
  entry.name[entry.name_length] = 0;
  const std::uint64_t size = cursor_.read_varint();
  const std::uint64_t kind = (head & kHasKind) != 0 ? cursor_.read_varint() : entry.kind;
  const std::uint64_t tag_set = (head & kHasTags) != 0 ? cursor_.read_varint() : entry.tag_set;
  const bool is_possible =
      !cursor_.failed() && data_ >= sizeof bank_ && data_ <= bank_.bytes &&
      aligned_in(bank_, data_) == data_ && size <= bank_.bytes - data_ &&
      kind < bank_.count(bank_.is_cooked() ? BankItem::Part : BankItem::Outline) &&
      tag_set < bank_.count(BankItem::TagSet);
  if (!is_possible) return false;
  entry.kind = static_cast<std::uint32_t>(kind);
  entry.tag_set = static_cast<std::uint32_t>(tag_set);
  entry.number = number_++;
  entry.place = {data_, size};
  data_ = aligned_in(bank_, data_ + size);
  return true;
}

/// Decodes a number of bytes in an entry's name. `told` holds the number in its lowest bits; if
/// these are kNameMask, a varint follows, which is added.
std::uint64_t EntryWalk::name_part(unsigned told) {
  told &= kNameMask;
  return told < kNameMask ? told : kNameMask + cursor_.read_varint();
}

bool read_entry(const mcpk_bank& bank, std::uint32_t clip, BankEntry& entry) {
  if (clip >= bank.clips) return false;
  EntryWalk walk(bank, clip / kClipsOfBlock);
  for (std::uint32_t left = clip % kClipsOfBlock + 1; left > 0; --left)
    if (!walk.next(entry)) return false;
  return true;
}

std::int64_t find_clip(const mcpk_bank& bank, const char* name, std::size_t length) {
  BankEntry entry;
  const auto order = [&] { return compare_names(entry.name, entry.name_length, name, length); };
  // Binary search for the last block whose first name is `name`, or comes before it.
  std::uint32_t first = 0;
  std::uint32_t end = bank.blocks();
  while (end - first > 1) {
    const std::uint32_t middle = first + (end - first) / 2;
    if (!EntryWalk(bank, middle).next(entry)) return -1;
    (order() <= 0 ? first : end) = middle;
  }
  EntryWalk walk(bank, first);
  for (std::int64_t clip = std::int64_t{kClipsOfBlock} * first; walk.next(entry); ++clip)
    if (order() == 0) return clip;
  return -1;
}

int compare_names(const char* a, std::size_t a_length, const char* b, std::size_t b_length) {
  const int order = std::memcmp(a, b, std::min(a_length, b_length));
  if (order != 0) return order;
  return a_length < b_length ? -1 : a_length > b_length ? 1 : 0;
}

}  // namespace mocapress::runtime

mocapress::runtime::Bytes mcpk_bank::item(mocapress::runtime::BankItem kind,
                                          std::uint32_t number) const {
  if (number >= count(kind)) return {};
  std::uint64_t at_item = number;
  for (int k = 0; k < static_cast<int>(kind); ++k) at_item += item_counts[k];
  std::uint32_t ends[2];
  std::memcpy(ends, at(items.offset + 4 * at_item), sizeof ends);
  if (ends[0] > ends[1] || ends[1] > items.bytes) return {};
  return bytes_of({items.offset + ends[0], ends[1] - ends[0]});
}

const char* mcpk_bank::text(mocapress::runtime::BankItem kind, std::uint32_t number) const {
  const mocapress::runtime::Bytes found = item(kind, number);
  const bool ends = found.size > 0 && found.data[found.size - 1] == 0;
  return ends ? reinterpret_cast<const char*>(found.data) : nullptr;
}
