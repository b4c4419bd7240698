// SPDX-License-Identifier: MIT
#include "core/base/make_folders.h"

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// True if a folder is at the path. If false, errno tells why.
bool is_folder(const fs::path& path) {
  const auto status = status_of(path);
  if (status) errno = EEXIST;
  return status && status->kind == PathKind::Folder;
}

[[noreturn]] void fail(const fs::path& folder, int error) {
  throw WriteError(utf8(folder) + ": cannot be made: " + std::strerror(error));
}

}  // namespace

void make_folders(const fs::path& folder) {
  if (folder.empty()) return;
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  bool made = make_folder(named);
  if (!made && errno == ENOENT && named.has_parent_path() && named.has_relative_path()) {
    make_folders(named.parent_path());
    made = make_folder(named);
  }
  if (!made && errno == EEXIST && is_folder(named)) return;
  if (!made || !synchronise_folder_of(named)) fail(folder, errno);
}

}  // namespace mocapress
