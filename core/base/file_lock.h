// SPDX-License-Identifier: MIT
// After flock(2).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {

/// The right to read a file and then to replace it, which one has at a time, of all that ask for
/// it. Given back at the end.
class FileLock {
 public:
  /// As flock(2).
  using Lock = int (*)(int file, int operation);

  /// Locks the file at the end of a place's links, once those that have it give it back. There is
  /// nothing to lock where there is no file. Unset: `may_wait`, asked every few milliseconds, said
  /// no. Throws InputError where the file is there but cannot be opened.
  static std::optional<FileLock> wait_for(const std::filesystem::path& path,
                                          const std::function<bool()>& may_wait);
  static std::optional<FileLock> wait_for(const std::filesystem::path& path,
                                          const std::function<bool()>& may_wait, Lock lock);

  /// Says that the file could not be locked, as where the file system has no locks: then nothing
  /// keeps other processes away.
  const std::optional<Warning>& warning() const { return warning_; }

 private:
  explicit FileLock(FileDescriptor file, std::optional<Warning> warning = {})
      : file_(std::move(file)), warning_(std::move(warning)) {}

  FileDescriptor file_;
  std::optional<Warning> warning_;
};

}  // namespace mocapress
