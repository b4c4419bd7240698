// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace mocapress {

/// A file written beside its place, to be looked at before it takes that place.
class StagedFile {
 public:
  /// Writes `path`.part, in folders made for it. Throws WriteError.
  StagedFile(std::filesystem::path path, std::span<const std::byte> bytes);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Removes what was not put in place.
  ~StagedFile();

  const std::filesystem::path& path() const { return path_; }

  /// What the disk gives back. Throws InputError.
  std::vector<std::byte> read_back() const;

  /// Renames it to its place. Throws WriteError, also when a file is there and `replace` is false.
  void put_in_place(bool replace);

 private:
  std::filesystem::path path_;
  std::filesystem::path part_;  // empty: in place, or moved from
};

}  // namespace mocapress
