// SPDX-License-Identifier: MIT
// Where the clips of a new bank come from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
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

/// Reads sources. The banks that hold some stay open, each once, however the names of their clips
/// alternate.
class BankSourceReader {
 public:
  struct File {
    std::vector<std::byte> bytes;  // of a .mcpr
    std::vector<std::string> tags;
  };

  /// Throws InputError.
  explicit BankSourceReader(const std::vector<BankSource>& sources);

  /// May be called by many threads. Throws InputError.
  File read(const BankSource& source) const;

 private:
  std::map<std::filesystem::path, BankFile> banks_;
};

}  // namespace mocapress
