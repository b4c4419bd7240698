// SPDX-License-Identifier: MIT
// A file mapped into memory, by mmap(2).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace mocapress {

/// A file's bytes mapped into memory and read where they are used. Replacing the file leaves these
/// bytes as they were.
class MappedFile {
 public:
  /// Throws InputError. Pages are loaded as they are touched, or all `beforehand`, which takes
  /// longer but never waits later.
  explicit MappedFile(const std::filesystem::path& path, bool beforehand = false);
  /// Maps the file open under this number; unset if that fails, and errno tells why.
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
