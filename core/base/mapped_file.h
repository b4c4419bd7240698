// SPDX-License-Identifier: MIT
// After mmap(2).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace mocapress {

/// A file as it lies on disk, read where it is used. What replaces the file leaves this one as it
/// was.
class MappedFile {
 public:
  /// Throws InputError.
  /// Pages come as they are touched, or all `beforehand`: that takes longer, and no touch waits.
  explicit MappedFile(const std::filesystem::path& path, bool beforehand = false);
  /// A file that is open under this number; none where errno says why it cannot be.
  static std::optional<MappedFile> of_descriptor(int file, bool beforehand = false);
  MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
  MappedFile& operator=(MappedFile&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~MappedFile();

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  MappedFile() = default;

  std::span<const std::byte> bytes_;
};

}  // namespace mocapress
