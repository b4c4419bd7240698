// SPDX-License-Identifier: MIT
// After flock(2).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/staged_file.h"

namespace mocapress {

/// The right to read a file and then to replace it, which one has at a time, of all that ask for
/// it. Given back at the end.
class FileLock {
 public:
  /// Of the file at the end of a place's links, once those that have it give it back. There is
  /// nothing to lock where there is no file, or where its file system has no locks. Unset:
  /// `may_wait`, asked every few milliseconds, said no.
  static std::optional<FileLock> wait_for(const std::filesystem::path& path,
                                          const std::function<bool()>& may_wait);

 private:
  explicit FileLock(FileDescriptor file) : file_(std::move(file)) {}

  FileDescriptor file_;
};

}  // namespace mocapress
