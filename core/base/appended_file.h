// SPDX-License-Identifier: MIT
// A file that is only appended to, by open(2) with O_APPEND, and locked by flock(2).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {

/// Thrown if another process has the file open.
class InUse : public WriteError {
  using WriteError::WriteError;
};

/// A text file that lines are appended to, open in one process at a time. When append() returns,
/// the line is on the disk; a line that could not be written whole is cut off again.
class AppendedFile {
 public:
  /// A function like lock_now() of open_file.h.
  using Lock = int (*)(int file);

  /// Opens the file or creates it. Follows links as StagedFile does. Throws InUse while another
  /// process has the file open, InputError if the system cannot tell what is at the path, and
  /// WriteError for any other failure.
  explicit AppendedFile(std::filesystem::path path, Lock lock);
  explicit AppendedFile(std::filesystem::path path);
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  /// Removes the file if this object created it and it is still empty.
  ~AppendedFile();

  /// Set if the file could not be locked, as on a file system without locks, so that other
  /// processes can open it, too.
  const std::optional<Warning>& warning() const { return warning_; }

  std::uint64_t size() const { return size_; }

  /// Reads `length` bytes, or fewer at the end of the file. Throws InputError.
  std::string read(std::uint64_t offset, std::size_t length) const;

  /// Appends `line` and a line end. Throws WriteError.
  void append(std::string_view line);

  /// Replaces all contents at once by what `write` writes. Throws WriteError, and whatever `write`
  /// throws.
  void replace(const std::function<void(StagedFile&)>& write);

 private:
  struct Opened {
    FileDescriptor file;
    bool made = false;
  };

  void open();
  Opened open_at_its_place() const;
  void take_lock(int file);
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  std::filesystem::path target_;  // the file at the end of the path's links
  Lock lock_;
  FileDescriptor file_;
  bool made_ = false;
  std::uint64_t size_ = 0;
  std::optional<Warning> warning_;
};

}  // namespace mocapress
