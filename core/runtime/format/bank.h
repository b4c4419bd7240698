// SPDX-License-Identifier: MIT
// Many clips in one file, .mcpk: FORMAT.md, "The bank". Read where it lies, in memory or mapped
// from disk; nothing is decoded to open it. core/bank writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/result.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

enum class BankForm : std::uint16_t { Packed, Cooked };

/// What clips have in common, or what is there once: numbered one kind after the other.
enum class BankItem : std::uint8_t {
  Part,     // packed: a section of clips, its tag first; cooked: a skeleton
  Outline,  // packed: which sections a clip has
  Tag,      // a text that ends with a zero
  TagSet,   // u32 numbers of tags, ascending
  Text      // keys and values of the bank, in turn; each ends with a zero
};
inline constexpr int kBankItems = 5;

inline constexpr std::uint32_t kClipsOfBlock = 16;  // of the index
inline constexpr std::uint32_t kMostClipsOfBank = std::uint32_t{1} << 24;
inline constexpr std::size_t kMostNameOfClip = 255;  // bytes
inline constexpr std::size_t kMostTextOfBank = 65535;
// u64 place of the first clip, u32 of its entry, u32 checksum of the clips.
inline constexpr std::size_t kBlockBytes = 16;
// Of an entry's first byte: how many bytes of the end of the name before are dropped, how many come
// in their place less 1, and whether kind and tags are told or those of the entry before.
inline constexpr unsigned kNameMask =
    7;  // of each: 7 says that a number follows, of what is beyond
inline constexpr int kNewNameShift = 3;
inline constexpr unsigned kHasKind = 0x40;
inline constexpr unsigned kHasTags = 0x80;
inline constexpr std::uint64_t kCookedAlignment = 32;  // of cooked clips, and of their tables
inline constexpr std::uint64_t kFirstTable = 32;  // no table lies before: an offset of 0 is none

/// Where something lies in a bank.
struct BankRegion {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// What the index says of a clip.
struct BankEntry {
  char name[kMostNameOfClip + 1] = {};  // ends with a zero
  std::uint8_t name_length = 0;
  std::uint32_t kind = 0;  // packed: its outline; cooked: its skeleton
  std::uint32_t tag_set = 0;
  BankRegion place;
};

std::uint32_t bank_checksum(const void* bytes, std::size_t size);

}  // namespace mocapress::runtime

/// The head of the file, and so the bank.
struct mcpk_bank {
  static constexpr char kMagic[4] = {'M', 'C', 'P', 'K'};
  static constexpr std::uint16_t kVersion = 2;
  char magic[4];
  std::uint16_t version;
  mocapress::runtime::BankForm form;
  std::uint64_t bytes;  // of all
  mocapress::runtime::BankRegion index;
  mocapress::runtime::BankRegion items;
  mocapress::runtime::BankRegion tables;  // of cooked clips
  std::uint32_t clips;
  std::uint32_t item_counts[mocapress::runtime::kBankItems];
  std::uint32_t index_checksum;
  std::uint32_t items_checksum;
  std::uint32_t tables_checksum;
  std::uint32_t checksum;  // of the head before it

  const std::uint8_t* at(std::uint64_t offset) const {
    return reinterpret_cast<const std::uint8_t*>(this) + offset;
  }
  mocapress::runtime::Bytes bytes_of(const mocapress::runtime::BankRegion& region) const {
    return {at(region.offset), static_cast<std::size_t>(region.bytes),
            static_cast<std::size_t>(region.offset)};
  }
  bool is_cooked() const { return form == mocapress::runtime::BankForm::Cooked; }
  std::uint32_t count(mocapress::runtime::BankItem kind) const {
    return item_counts[static_cast<int>(kind)];
  }
  std::uint32_t blocks() const {
    return (clips + mocapress::runtime::kClipsOfBlock - 1) / mocapress::runtime::kClipsOfBlock;
  }
  /// No data where there is no such item, or it lies beyond the end.
  mocapress::runtime::Bytes item(mocapress::runtime::BankItem kind, std::uint32_t number) const;

  /// A text among the items; null where there is none.
  const char* text(mocapress::runtime::BankItem kind, std::uint32_t number) const;
};

namespace mocapress::runtime {

/// Whether the head is that of a bank in so many bytes, and all that it names lies within. Looks at
/// nothing else.
mcpr_result check_bank_head(const mcpk_bank& bank, std::size_t size);

/// Walks the entries of an index, from a block's first. Each needs the one before it.
class EntryWalk {
 public:
  EntryWalk(const mcpk_bank& bank, std::uint32_t block);

  /// False where there is none, or its bytes make no sense.
  bool next(BankEntry& entry);

  std::size_t offset() const { return cursor_.offset(); }  // in the file

  /// Of the block: packed: CRC-32 of the bytes of its clips; cooked: of their own checksums.
  std::uint32_t checksum() const { return checksum_; }

 private:
  std::uint64_t name_part(unsigned told);

  const mcpk_bank& bank_;
  Cursor cursor_;
  std::uint64_t data_ = 0;
  std::uint32_t checksum_ = 0;
  std::uint32_t left_ = 0;  // entries of the block
  bool is_first_ = true;
};

/// False where there is none, or its bytes make no sense.
bool read_entry(const mcpk_bank& bank, std::uint32_t clip, BankEntry& entry);

/// The number of the clip of that name; -1: there is none.
std::int64_t find_clip(const mcpk_bank& bank, const char* name, std::size_t length);

/// Byte by byte: below 0, 0, above 0.
int compare_names(const char* a, std::size_t a_length, const char* b, std::size_t b_length);

/// In groups of 7 bits, the lowest first; the eighth says that more follow.
std::uint64_t read_varint(Cursor& cursor);

}  // namespace mocapress::runtime
