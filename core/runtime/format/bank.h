// SPDX-License-Identifier: MIT
// Many clips in one file, .mcpk: FORMAT.md, "The bank". A bank is used in place, in memory or
// mapped from disk; opening one decodes nothing. core/bank writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/result.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

enum class BankForm : std::uint16_t { Packed, Cooked };

/// Kinds of the items that clips share. The items of each kind have numbers of their own, from 0
/// on.
enum class BankItem : std::uint8_t {
  Part,     // packed: a section of clips, its tag first; cooked: a skeleton
  Outline,  // packed: the list of sections of a clip
  Tag,      // zero-terminated text
  TagSet,   // u32 numbers of tags, ascending
  Text      // keys and values of the bank, alternating, each zero-terminated
};
inline constexpr int kBankItems = 5;

inline constexpr std::uint32_t kClipsOfBlock = 16;  // clips in a block of the index
inline constexpr std::uint32_t kMostClipsOfBank = std::uint32_t{1} << 24;
inline constexpr std::size_t kMostNameOfClip = 255;  // bytes, without the terminating zero
inline constexpr std::size_t kMostTextOfBank = 65535;
// A block's head: u64 offset of its first clip, u32 offset of its first entry, u32 checksum of its
// clips.
inline constexpr std::size_t kBlockBytes = 16;
// The first byte of an entry packs four fields: bytes dropped from the end of the previous name (3
// bits), bytes appended less 1 (3 bits), and two flags. The flags tell that the clip's kind, or its
// set of tags, differs from the previous entry's.
inline constexpr unsigned kNameMask = 7;  // 7 in either number of bytes: a varint follows, which is
                                          // added
inline constexpr int kNewNameShift = 3;
inline constexpr unsigned kHasKind = 0x40;
inline constexpr unsigned kHasTags = 0x80;
inline constexpr std::uint64_t kCookedAlignment = 32;  // in bytes, for cooked clips and for their
                                                       // tables
inline constexpr std::uint64_t kFirstTable = 32;  // tables start here, so that offset 0 can mean
                                                  // "none"

/// A range of bytes of the bank.
struct BankRegion {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// A clip's entry in the index.
struct BankEntry {
  char name[kMostNameOfClip + 1] = {};  // zero-terminated
  std::uint8_t name_length = 0;
  std::uint32_t number = 0;  // number of the clip
  std::uint32_t kind = 0;    // packed: item number of its outline; cooked: of its skeleton
  std::uint32_t tag_set = 0;
  BankRegion place;
};

std::uint32_t bank_checksum(const void* bytes, std::size_t size);

}  // namespace mocapress::runtime

/// The head of the file. A pointer to it stands for the whole bank.
struct mcpk_bank {
  static constexpr char kMagic[4] = {'M', 'C', 'P', 'K'};
  static constexpr std::uint16_t kVersion = 2;
  char magic[4];
  std::uint16_t version;
  mocapress::runtime::BankForm form;
  std::uint64_t bytes;  // size of the whole bank
  mocapress::runtime::BankRegion index;
  mocapress::runtime::BankRegion items;
  mocapress::runtime::BankRegion tables;  // cooked: tables that clips share; packed: bank_tiers.h
  std::uint32_t clips;
  std::uint32_t item_counts[mocapress::runtime::kBankItems];
  std::uint32_t index_checksum;
  std::uint32_t items_checksum;
  std::uint32_t tables_checksum;
  std::uint32_t checksum;  // over the head up to here

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
  /// Returns an item. Its data is null if there is no such item, or if it lies beyond the bank's
  /// end.
  mocapress::runtime::Bytes item(mocapress::runtime::BankItem kind, std::uint32_t number) const;

  /// Returns a zero-terminated text item; null if there is none.
  const char* text(mocapress::runtime::BankItem kind, std::uint32_t number) const;
};

namespace mocapress::runtime {

/// Checks that the head is that of a bank of at most `size` bytes, and that all regions lie within
/// the bank. Reads nothing but the head.
mcpr_result check_bank_head(const mcpk_bank& bank, std::size_t size);

/// Walks the entries of a block of the index in order. Each entry is coded relative to the previous
/// one.
class EntryWalk {
 public:
  EntryWalk(const mcpk_bank& bank, std::uint32_t block);

  /// Reads the next entry. Returns false at the end of the block, or if the bytes are invalid.
  bool next(BankEntry& entry);

  std::size_t offset() const { return cursor_.offset(); }  // position in the file

  /// Checksum of the block's clips: CRC-32 of their bytes in a packed bank, of their own checksums
  /// in a cooked one.
  std::uint32_t checksum() const { return checksum_; }

 private:
  std::uint64_t name_part(unsigned told);

  const mcpk_bank& bank_;
  Cursor cursor_;
  std::uint64_t data_ = 0;
  std::uint32_t checksum_ = 0;
  std::uint32_t number_ = 0;  // number of the next entry's clip
  std::uint32_t left_ = 0;    // entries left in the block
  bool is_first_ = true;
};

/// Reads the entry of one clip. Returns false if there is no such clip, or if the bytes are
/// invalid.
bool read_entry(const mcpk_bank& bank, std::uint32_t clip, BankEntry& entry);

/// Number of the clip with this name; -1 if there is none.
std::int64_t find_clip(const mcpk_bank& bank, const char* name, std::size_t length);

/// Compares byte by byte: negative, zero or positive, as memcmp().
int compare_names(const char* a, std::size_t a_length, const char* b, std::size_t b_length);

}  // namespace mocapress::runtime
