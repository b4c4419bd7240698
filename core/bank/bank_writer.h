// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/staged_file.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/format/bank.h"

namespace mocapress {

/// Distinct byte strings, numbered in the order of their first use.
class InternedBytes {
 public:
  std::uint32_t intern(std::span<const std::byte> bytes);
  const std::vector<const std::string*>& all() const { return all_; }

 private:
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<const std::string*> all_;
};

/// Distinct tables of cooked clips, all in one block.
class SharedTables {
 public:
  SharedTables() : bytes_(runtime::kFirstTable) {}

  /// Adds a table unless it is there already. Returns its offset in the block, which has the
  /// alignment that tables need.
  std::uint32_t intern(std::span<const std::byte> table);
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  struct Table {
    std::uint32_t place;
    std::size_t bytes;
  };
  std::unordered_multimap<std::size_t, Table> places_;  // by hash of the table
  std::vector<std::byte> bytes_;
};

/// Texts about a bank for people to read: pairs of key and value.
using BankTexts = std::vector<std::pair<std::string, std::string>>;

/// Writes a bank clip by clip, in the order of the clips' names, into a file that appears at its
/// path whole or not at all. Keeps in memory only the index and what clips share.
class BankWriter {
 public:
  /// Throws WriteError, like all members.
  BankWriter(const std::filesystem::path& path, runtime::BankForm form);

  std::uint32_t intern(runtime::BankItem kind, std::span<const std::byte> bytes);
  SharedTables& tables() { return tables_; }

  /// Adds a clip. Throws InputError if the name is invalid or does not come after the last one.
  /// `pieces` are what finer tiers add to a packed clip; they are kept in memory until finish().
  void add(const std::string& name, std::uint32_t kind, std::span<const std::byte> bytes,
           std::vector<std::string> tags, const ClipPieces& pieces = {});

  /// Reads the file back, checks it and puts it in place.
  void finish(const BankTexts& texts);

 private:
  std::uint32_t tag_set(std::vector<std::string> tags);
  void put_entry(const std::string& name, std::uint32_t kind, std::uint32_t tags,
                 std::uint64_t size);
  void end_block();
  std::vector<std::byte> tier_table() const;
  void write(std::span<const std::byte> bytes);
  void align(std::uint64_t alignment);
  runtime::BankRegion write_region(std::span<const std::byte> bytes, std::uint64_t alignment,
                                   std::uint32_t& checksum);
  std::vector<std::byte> item_bytes(const BankTexts& texts, mcpk_bank& head);

  StagedFile file_;
  runtime::BankForm form_;
  std::uint64_t written_ = 0;
  InternedBytes items_[runtime::kBankItems];
  SharedTables tables_;
  std::string last_name_;
  std::uint32_t last_kind_ = 0;
  std::uint32_t last_tags_ = 0;
  std::vector<std::byte> blocks_;
  std::vector<std::byte> checked_;  // bytes that the latest block's checksum covers
  std::vector<std::byte> entries_;
  std::vector<std::uint64_t>
      clips_;  // offset of each cooked clip; finish() stores the distance to the tables in each
  std::uint32_t count_ = 0;
  struct TierPieces {
    std::vector<std::byte> bytes;       // pieces of all clips, back to back
    std::vector<std::uint32_t> begins;  // offset of each clip's piece in `bytes`
  };
  std::vector<TierPieces> tiers_;
};

}  // namespace mocapress
