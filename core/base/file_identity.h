// SPDX-License-Identifier: MIT
// Tells whether two paths lead to the same file, by stat(2).
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace mocapress {

/// The file or folder at the end of a path's links. Two paths with equal identities lead to the
/// same file, for example through a link, a hard link or another spelling.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;  // inode

  auto operator<=>(const FileIdentity&) const = default;
};

/// The identity of the file at a path; unset if nothing is there. Throws InputError if the path
/// cannot be examined.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Throws WriteError if writing to `place` would overwrite one of `sources`.
void refuse_source(const std::filesystem::path& place,
                   const std::vector<std::filesystem::path>& sources);

}  // namespace mocapress
