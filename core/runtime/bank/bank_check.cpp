// SPDX-License-Identifier: MIT
#include "core/runtime/bank/bank_check.h"

#include "core/runtime/format/bank_skeleton.h"
#include "core/runtime/format/bank_tiers.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/format/learned_priors.h"

namespace mocapress::runtime {
namespace {

mcpr_result check_checksum(const mcpk_bank& bank, const BankRegion& region, std::uint32_t checksum,
                           const char* message) {
  return bank_checksum(bank.at(region.offset), static_cast<std::size_t>(region.bytes)) == checksum
             ? kOk
             : failure(MCPR_DAMAGED, static_cast<std::size_t>(region.offset), message);
}

/// True if an item of a packed bank is a section, or valid learned priors. The contents of a
/// section are checked later, with each clip that uses it.
bool is_part(const Bytes& item) {
  constexpr std::size_t kTag = 4;
  if (item.size < kTag || std::memcmp(item.data, kLearned, kTag) != 0) return item.size >= kTag;
  return !failed(check_learned({item.data + kTag, item.size - kTag, item.offset + kTag}));
}

/// True if an item is a valid set of tags: ascending numbers of existing tags.
bool is_tag_set(const mcpk_bank& bank, const Bytes& item) {
  if (item.size % sizeof(std::uint32_t) != 0) return false;
  std::int64_t before = -1;
  Cursor cursor = item.cursor();
  while (!cursor.at_end()) {
    const auto tag = cursor.read<std::uint32_t>();
    if (tag <= before || tag >= bank.count(BankItem::Tag)) return false;
    before = tag;
  }
  return true;
}

mcpr_result check_items(const mcpk_bank& bank) {
  const auto refuse = [&](const Bytes& item) {
    return failure(MCPR_INVALID,
                   item.data != nullptr ? item.offset : static_cast<std::size_t>(bank.items.offset),
                   "an impossible item of the bank");
  };
  for (int k = 0; k < kBankItems; ++k) {
    const auto kind = static_cast<BankItem>(k);
    for (std::uint32_t i = 0; i < bank.count(kind); ++i) {
      const Bytes item = bank.item(kind, i);
      bool is_sound = item.data != nullptr;
      if (is_sound && (kind == BankItem::Tag || kind == BankItem::Text))
        is_sound = bank.text(kind, i) != nullptr &&
                   std::memchr(item.data, 0, item.size) == item.data + item.size - 1;
      if (is_sound && kind == BankItem::TagSet) is_sound = is_tag_set(bank, item);
      if (is_sound && kind == BankItem::Part && bank.is_cooked())
        is_sound = BankSkeleton(item).is_sound();
      if (is_sound && kind == BankItem::Part && !bank.is_cooked()) is_sound = is_part(item);
      if (!is_sound) return refuse(item);
    }
  }
  return kOk;
}

/// True if the gap between two parts of the bank is shorter than kCookedAlignment and holds only
/// zeros. The bytes are not read unless `is_there`.
bool is_padding(const mcpk_bank& bank, std::uint64_t from, std::uint64_t to, bool is_there = true) {
  if (to < from || to - from >= kCookedAlignment) return false;
  for (; is_there && from < to; ++from)
    if (*bank.at(from) != 0) return false;
  return true;
}

/// Checks the checksum of a block of 16 clips, then each of the clips.
mcpr_result check_clips(const mcpk_bank& bank, std::uint32_t block) {
  const auto damaged = [](std::uint64_t offset) {
    return failure(MCPR_DAMAGED, static_cast<std::size_t>(offset),
                   "clips of the bank are damaged: their checksum differs");
  };
  BankEntry entry;
  EntryWalk clips(bank, block);
  std::uint32_t own[kClipsOfBlock];
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::size_t count = 0;
  for (; clips.next(entry); ++count) {
    if (count == 0) begin = entry.place.offset;
    end = entry.place.offset + entry.place.bytes;
    if (!bank.is_cooked()) continue;
    const mcpr_cooked* cooked = nullptr;
    const mcpr_result result = cooked_clip_of(bank, entry, cooked);
    if (failed(result)) return result;
    own[count] = cooked->checksum;
  }
  const std::uint32_t checksum =
      bank.is_cooked() ? bank_checksum(own, count * sizeof *own)
                       : bank_checksum(bank.at(begin), static_cast<std::size_t>(end - begin));
  if (checksum != clips.checksum()) return damaged(begin);
  EntryWalk again(bank, block);
  while (again.next(entry))
    if (const mcpr_result result = check_clip(bank, entry); failed(result)) return result;
  return kOk;
}

/// Checks that the clips, and the regions of the bank, follow each other with no gap but padding.
/// With `clips`, also checks the contents of the clips.
mcpr_result check_index(const mcpk_bank& bank, bool clips) {
  const Bytes index = bank.bytes_of(bank.index);
  const auto refuse = [&](std::size_t offset) {
    return failure(MCPR_INVALID, offset, "the index of the bank makes no sense");
  };
  BankEntry entry;
  BankEntry before;
  std::uint64_t clips_end = sizeof bank;
  std::size_t end = index.offset + kBlockBytes * bank.blocks();
  for (std::uint32_t block = 0; block < bank.blocks(); ++block) {
    EntryWalk walk(bank, block);
    if (walk.offset() != end) return refuse(end);
    const std::uint32_t first = kClipsOfBlock * block;
    for (std::uint32_t clip = first; clip < bank.clips && clip < first + kClipsOfBlock; ++clip) {
      const bool is_there = walk.next(entry);
      const bool follows = is_there && is_padding(bank, clips_end, entry.place.offset, clips) &&
                           (clip == 0 || compare_names(before.name, before.name_length, entry.name,
                                                       entry.name_length) < 0);
      if (!follows || std::memchr(entry.name, 0, entry.name_length) != nullptr)
        return refuse(walk.offset());
      clips_end = entry.place.offset + entry.place.bytes;
      before = entry;
    }
    if (clips)
      if (const mcpr_result result = check_clips(bank, block); failed(result)) return result;
    end = walk.offset();
  }
  const auto follows = [&](const BankRegion& region, std::uint64_t before_it) {
    return is_padding(bank, before_it, region.offset);
  };
  const bool is_whole = end == index.offset + index.size &&
                        is_padding(bank, clips_end, bank.items.offset, clips) &&
                        follows(bank.index, bank.items.offset + bank.items.bytes) &&
                        follows(bank.tables, bank.index.offset + bank.index.bytes) &&
                        (!bank.is_cooked() || bank.tables.offset + bank.tables.bytes == bank.bytes);
  return is_whole ? BankTiers(bank).check(clips) : refuse(end);
}

}  // namespace

mcpr_result cooked_clip_of(const mcpk_bank& bank, const BankEntry& entry,
                           const mcpr_cooked*& cooked) {
  const auto offset = static_cast<std::size_t>(entry.place.offset);
  const auto damaged = failure(MCPR_DAMAGED, offset, "a clip of the bank is damaged");
  if (entry.place.bytes < sizeof(mcpr_cooked)) return damaged;
  const auto* const clip = reinterpret_cast<const mcpr_cooked*>(bank.at(entry.place.offset));
  const mcpr_result result = check_cooked_head(*clip, static_cast<std::size_t>(entry.place.bytes));
  if (failed(result)) return failure(result.status, offset + result.offset, result.message);
  if (clip->tables != static_cast<std::int64_t>(bank.tables.offset - entry.place.offset))
    return damaged;
  cooked = clip;
  return kOk;
}

mcpr_result check_clip(const mcpk_bank& bank, const BankEntry& entry) {
  const auto offset = static_cast<std::size_t>(entry.place.offset);
  if (!bank.is_cooked()) {
    FileSections sections;
    return read_sections(bank, entry, or_default(nullptr), sections);
  }
  const mcpr_cooked* cooked = nullptr;
  mcpr_result result = cooked_clip_of(bank, entry, cooked);
  if (!failed(result) && cooked->bytes != entry.place.bytes)
    result = failure(MCPR_DAMAGED, 0, "a clip of the bank has another size than it says");
  if (!failed(result))
    result = check_cooked(*cooked, {cooked->tables, kFirstTable, bank.tables.bytes});
  if (failed(result)) return failure(result.status, offset + result.offset, result.message);
  return cooked->joints == BankSkeleton(bank.item(BankItem::Part, entry.kind)).joints()
             ? kOk
             : failure(MCPR_INVALID, offset,
                       "a clip of the bank has another skeleton than it says");
}

mcpr_result check_bank(const mcpk_bank& bank, bool clips) {
  // Without `clips`, the bytes of the clips may be uninitialised (see mcpk_place). The order of the
  // regions is checked first, so that no region lies in those bytes.
  if (bank.index.offset < bank.items.offset + bank.items.bytes ||
      bank.tables.offset < bank.index.offset + bank.index.bytes)
    return failure(MCPR_INVALID, 0, "the parts of the bank are out of order");
  mcpr_result result = check_checksum(bank, bank.index, bank.index_checksum,
                                      "the index of the bank is damaged: its checksum differs");
  if (!failed(result))
    result = check_checksum(bank, bank.items, bank.items_checksum,
                            "the items of the bank are damaged: their checksum differs");
  if (!failed(result))
    result = check_checksum(bank, bank.tables, bank.tables_checksum,
                            "the tables of the bank are damaged: their checksum differs");
  if (!failed(result)) result = check_items(bank);
  return failed(result) ? result : check_index(bank, clips);
}

}  // namespace mocapress::runtime
