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

/// Finds sources in the inputs. A file is named by its stem, each .mcpr below a folder by its path
/// from that folder without extension, and each clip of a packed bank keeps its name. Throws
/// InputError for a folder without a .mcpr, and for a cooked bank.
std::vector<BankSource> find_bank_sources(const std::vector<std::filesystem::path>& inputs);

/// Reads sources. Each bank among them is opened once and stays open, whatever the order of the
/// clips.
class BankSourceReader {
 public:
  struct File {
    std::vector<std::byte> bytes;  // the .mcpr
    std::vector<std::string> tags;
  };

  /// Throws InputError.
  explicit BankSourceReader(const std::vector<BankSource>& sources);

  /// Reads one source. Many threads may call it. Throws InputError.
  File read(const BankSource& source) const;

 private:
  std::map<std::filesystem::path, BankFile> banks_;
};

}  // namespace mocapress
