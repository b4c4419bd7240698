// SPDX-License-Identifier: MIT
#include "core/base/make_folders.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// If false, errno tells why.
bool is_folder(const fs::path& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0) return false;
  errno = EEXIST;
  return S_ISDIR(status.st_mode);
}

[[noreturn]] void fail(const fs::path& folder, int error) {
  throw WriteError(folder.string() + ": cannot be made: " + std::strerror(error));
}

}  // namespace

void make_folders(const fs::path& folder) {
  constexpr mode_t kNewFolder = 0777;
  if (folder.empty()) return;
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  int failed = ::mkdir(named.c_str(), kNewFolder);
  if (failed && errno == ENOENT && named.has_parent_path()) {
    make_folders(named.parent_path());
    failed = ::mkdir(named.c_str(), kNewFolder);
  }
  if (failed && errno == EEXIST && is_folder(named)) return;
  if (failed) fail(folder, errno);
  const FileDescriptor parent = open_folder_of(named);
  if (!parent || !synchronise_folder(parent.number())) fail(folder, errno);
}

}  // namespace mocapress
