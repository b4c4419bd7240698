// SPDX-License-Identifier: MIT
// Where the clips of a new bank come from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/bank/bank_file.h"

namespace mocapress {

/// A clip to be put into a bank: a .mcpr file, or a clip of a packed bank.
struct BankSource {
  std::string name;  // in the new bank
  std::filesystem::path file;
  std::string of_bank;  // its name in there; empty: the file is a .mcpr
};

/// Files as they are, named by their stems; every .mcpr below folders, named by its path from there
/// without extension; every clip of a packed bank, by its name. Throws InputError for what holds
/// none.
std::vector<BankSource> find_bank_sources(const std::vector<std::filesystem::path>& inputs);

/// Reads sources; the bank of the last one stays open.
class BankSourceReader {
 public:
  struct File {
    std::vector<std::byte> bytes;  // of a .mcpr
    std::vector<std::string> tags;
  };
  /// Throws InputError.
  File read(const BankSource& source);

 private:
  std::optional<BankFile> bank_;
  std::filesystem::path path_;
};

}  // namespace mocapress
