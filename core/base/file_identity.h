// SPDX-License-Identifier: MIT
// Tells whether two paths are one file. After stat(2).
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace mocapress {

/// The file or folder behind a path, with links resolved. Paths of the same identity are one file:
/// a link, a hard link and another spelling of a path give the same.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;  // of the inode

  auto operator<=>(const FileIdentity&) const = default;
};

/// Unset: nothing is there. Throws InputError where the path cannot be looked at.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Throws WriteError where writing to `place` would write onto one of `sources`.
void refuse_source(const std::filesystem::path& place,
                   const std::vector<std::filesystem::path>& sources);

}  // namespace mocapress
