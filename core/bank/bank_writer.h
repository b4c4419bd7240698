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
#include "core/runtime/format/bank.h"

namespace mocapress {

/// Byte strings, each once, by the order in which they came.
class InternedBytes {
 public:
  std::uint32_t intern(std::span<const std::byte> bytes);
  const std::vector<const std::string*>& all() const { return all_; }

 private:
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<const std::string*> all_;
};

/// Tables of cooked clips in one block, each once.
class SharedTables {
 public:
  SharedTables() : bytes_(runtime::kFirstTable) {}

  /// Where they are, from the block on; alignments are as the tables have them by themselves.
  std::uint32_t intern(std::span<const std::byte> table);
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  struct Table {
    std::uint32_t place;
    std::size_t bytes;
  };
  std::unordered_multimap<std::size_t, Table> places_;  // by hash: the bytes stand below
  std::vector<std::byte> bytes_;
};

/// Keys with their values, and the other way a text for people to read.
using BankTexts = std::vector<std::pair<std::string, std::string>>;

/// Writes a bank clip by clip, in the order of their names, into a file that takes its place whole
/// or not at all. Only the index is in memory, and what clips share.
class BankWriter {
 public:
  /// Throws WriteError, as all of these do.
  BankWriter(const std::filesystem::path& path, runtime::BankForm form);

  std::uint32_t intern(runtime::BankItem kind, std::span<const std::byte> bytes);
  SharedTables& tables() { return tables_; }

  /// Also throws InputError where the name is impossible or does not follow upon the one before.
  void add(const std::string& name, std::uint32_t kind, std::span<const std::byte> bytes,
           std::vector<std::string> tags);

  /// Puts the file in place, after it was read back and found sound.
  void finish(const BankTexts& texts);

 private:
  std::uint32_t tag_set(std::vector<std::string> tags);
  void put_entry(const std::string& name, std::uint32_t kind, std::uint32_t tags,
                 std::uint64_t size);
  void end_block();
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
  std::vector<std::byte> checked_;  // what the checksum of the last block is of
  std::vector<std::byte> entries_;
  std::vector<std::uint64_t>
      clips_;  // where they begin: cooked ones, to tell them where tables are
  std::uint32_t count_ = 0;
};

}  // namespace mocapress
