// SPDX-License-Identifier: MIT
// A lock that keeps other processes from a file, by flock(2).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {

/// An exclusive lock held while a file is read and then replaced; released at the end.
class FileLock {
 public:
  /// A function like lock_now() of open_file.h.
  using Lock = int (*)(int file);

  /// Locks the file at the end of a path's links; waits while others hold the lock. Without a file
  /// at the path there is nothing to lock. Returns nothing if `may_wait`, which is asked every few
  /// milliseconds, returned false. Throws InputError if the file is there but cannot be opened.
  static std::optional<FileLock> wait_for(const std::filesystem::path& path,
                                          const std::function<bool()>& may_wait);
  static std::optional<FileLock> wait_for(const std::filesystem::path& path,
                                          const std::function<bool()>& may_wait, Lock lock);

  /// Set if the file could not be locked, as on a file system without locks, so that other
  /// processes can change it.
  const std::optional<Warning>& warning() const { return warning_; }

 private:
  explicit FileLock(FileDescriptor file, std::optional<Warning> warning = {})
      : file_(std::move(file)), warning_(std::move(warning)) {}

  FileDescriptor file_;
  std::optional<Warning> warning_;
};

}  // namespace mocapress
