// SPDX-License-Identifier: MIT
// The sources of a new bank's clips.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/bank/bank_file.h"

namespace mocapress {

/// A clip for a bank: a .mcpr file, or a clip of a packed bank.
struct BankSource {
  std::string name;  // name in the new bank
  std::filesystem::path file;
  std::string of_bank;  // name in its old bank; empty: the file is a .mcpr
};

/// Finds sources: files as given, named by their stems; every .mcpr below a folder, named by its
/// path from there without extension; every clip of a packed bank, by its name. Throws InputError
/// for an input without any.
std::vector<BankSource> find_bank_sources(const std::vector<std::filesystem::path>& inputs);

/// Reads sources. Banks among them stay open, each once, in whatever order their clips come.
class BankSourceReader {
 public:
  struct File {
    std::vector<std::byte> bytes;  // the .mcpr
    std::vector<std::string> tags;
  };

  /// Throws InputError.
  explicit BankSourceReader(const std::vector<BankSource>& sources);

  /// Many threads may call it. Throws InputError.
  File read(const BankSource& source) const;

 private:
  std::map<std::filesystem::path, BankFile> banks_;
};

}  // namespace mocapress
