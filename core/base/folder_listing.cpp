// SPDX-License-Identifier: MIT
#include "core/base/folder_listing.h"

#include <system_error>

namespace mocapress {
namespace {

namespace fs = std::filesystem;

PathKind kind_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::regular:
      return PathKind::File;
    case fs::file_type::directory:
      return PathKind::Folder;
    case fs::file_type::not_found:
      return PathKind::Absent;
    default:
      return PathKind::Other;
  }
}

}  // namespace

FolderListing list_folder(const fs::path& folder) {
  FolderListing listing;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    FolderEntry entry{at->path()};
    std::error_code why;
    entry.is_link = at->is_symlink(why);
    entry.kind = kind_of(at->status(why).type());  // calls the system for links only
    if (why) entry.problem = why.message();
    listing.entries.push_back(std::move(entry));
  }
  if (error) listing.problem = error.message();
  return listing;
}

}  // namespace mocapress
