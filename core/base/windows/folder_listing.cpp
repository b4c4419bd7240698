// SPDX-License-Identifier: MIT
#include "core/base/folder_listing.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/base/open_file.h"
#include "core/base/windows/system.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

FolderEntry entry_of(const fs::path& folder, const WIN32_FIND_DATAW& found) {
  FolderEntry entry{folder / found.cFileName};
  const DWORD attributes = found.dwFileAttributes;
  // Reparse points of other kinds are ordinary files, such as files of a cloud drive that are not
  // fetched yet.
  entry.is_link = (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
                  (found.dwReserved0 == IO_REPARSE_TAG_SYMLINK ||
                   found.dwReserved0 == IO_REPARSE_TAG_MOUNT_POINT);
  if (!entry.is_link) {
    entry.kind = (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? PathKind::Folder : PathKind::File;
  } else if (const std::optional<FileStatus> status = status_of(entry.path)) {
    entry.kind = status->kind;
  } else {
    entry.kind = is_absence(errno) ? PathKind::Absent : PathKind::Other;
    entry.problem = std::strerror(errno);
  }
  return entry;
}

std::string last_problem() {
  windows::failed();
  return std::strerror(errno);
}

}  // namespace

FolderListing list_folder(const fs::path& folder) {
  FolderListing listing;
  WIN32_FIND_DATAW found;
  const HANDLE search = ::FindFirstFileW(windows::system_path(folder / L"*").c_str(), &found);
  if (search == INVALID_HANDLE_VALUE) {
    // An empty root of a drive finds nothing, since it has no entries "." and "..".
    if (::GetLastError() != ERROR_FILE_NOT_FOUND) listing.problem = last_problem();
    return listing;
  }
  do {
    const std::wstring_view name = found.cFileName;
    if (name != L"." && name != L"..") listing.entries.push_back(entry_of(folder, found));
  } while (::FindNextFileW(search, &found));
  if (::GetLastError() != ERROR_NO_MORE_FILES) listing.problem = last_problem();
  ::FindClose(search);
  return listing;
}

}  // namespace mocapress
