// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/staged_file.h"

namespace mocapress {

/// Reads a text file line by line. Unlike std::getline(), which takes a read error for the end of
/// the file, it throws InputError.
class LineReader {
 public:
  /// Throws InputError where the file cannot be opened.
  explicit LineReader(const std::filesystem::path& path);

  /// Reads the next line, without its line end. Returns false at the end of the file. The last line
  /// need not have a line end.
  bool next(std::string& line);

  /// The offset in the file of the line that next() read last.
  std::uint64_t offset() const { return offset_; }

  /// Reads `length` bytes from `offset`. The position of next() does not change. Throws InputError,
  /// also if the file ends before.
  std::string read(std::uint64_t offset, std::size_t length) const;

 private:
  std::string read_up_to(std::uint64_t offset, std::size_t length) const;

  std::string path_;
  FileDescriptor file_;
  std::string piece_;              // part of the file that ends at offset piece_end_
  std::size_t next_in_piece_ = 0;  // where the next line begins in piece_
  std::uint64_t piece_end_ = 0;
  std::uint64_t offset_ = 0;
};

}  // namespace mocapress
