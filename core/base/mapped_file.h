// SPDX-License-Identifier: MIT
// A file mapped into memory, by mmap(2).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace mocapress {

/// A file's bytes, mapped into memory instead of copied. They stay as they are if the file is
/// replaced.
class MappedFile {
 public:
  /// Maps the file at a path. Pages are loaded on first access, or all at once if `beforehand`:
  /// that takes longer, but no access has to wait later. Throws InputError.
  explicit MappedFile(const std::filesystem::path& path, bool beforehand = false);
  /// Maps an open file, given by its descriptor. Unset if that fails; errno tells why.
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
