// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace mocapress {

/// A file or folder that the system holds open for us; closed at the end.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor();

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

// These answer whether it went well; errno says why not.

/// Writes everything, however often the system takes only a part.
bool write_all(int file, std::string_view bytes);

/// Waits until the contents are on the disk. A file system that has nothing to synchronise is
/// content.
bool synchronise(int file);

/// The folder that `file` is or will be in. It need not be readable.
FileDescriptor open_folder_of(const std::filesystem::path& file);

/// Waits until the names in an open folder are on the disk.
bool synchronise_folder(int folder);

}  // namespace mocapress
