// SPDX-License-Identifier: MIT
#include "core/base/path_kind.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "core/base/error.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// Unset if nothing is at the path.
std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) == 0) return status;
  if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
  throw InputError(path.string(), 0, 0,
                   std::string("cannot be looked at: ") + std::strerror(errno));
}

}  // namespace

PathKind path_kind(const fs::path& path) {
  const auto status = status_of(path);
  if (!status) return PathKind::Absent;
  if (S_ISREG(status->st_mode)) return PathKind::File;
  return S_ISDIR(status->st_mode) ? PathKind::Folder : PathKind::Other;
}

bool is_there(const fs::path& path) {
  return path_kind(path) != PathKind::Absent;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  const auto first = status_of(a);
  const auto second = status_of(b);
  return first && second && first->st_dev == second->st_dev && first->st_ino == second->st_ino;
}

}  // namespace mocapress
