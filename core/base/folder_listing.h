// SPDX-License-Identifier: MIT
// Lists folders. GCC's std::filesystem for Windows lists another folder than the one that was asked
// for where a path has more than 260 characters.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/path_kind.h"

namespace mocapress {

struct FolderEntry {
  std::filesystem::path path;  // below the path of the folder, as it was given
  bool is_link = false;
  PathKind kind = PathKind::Absent;  // at the end of its links
  std::string problem;               // why nothing was found there; else empty
};

struct FolderListing {
  std::vector<FolderEntry> entries;  // in no order
  std::string problem;               // why some may be missing; else empty
};

FolderListing list_folder(const std::filesystem::path& folder);

}  // namespace mocapress
