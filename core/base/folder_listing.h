// SPDX-License-Identifier: MIT
// Lists folders. Use this instead of std::filesystem, which by GCC for Windows lists a different
// folder if a path has more than 260 characters.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/path_kind.h"

namespace mocapress {

struct FolderEntry {
  std::filesystem::path path;  // the folder's path as it was given, and the name
  bool is_link = false;
  PathKind kind = PathKind::Absent;  // kind of the file at the end of a link
  std::string problem;               // why the kind is unknown; empty: it is known
};

struct FolderListing {
  std::vector<FolderEntry> entries;  // in no order
  std::string problem;               // why entries may be missing; empty: none is
};

FolderListing list_folder(const std::filesystem::path& folder);

}  // namespace mocapress
