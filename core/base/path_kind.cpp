// SPDX-License-Identifier: MIT
#include "core/base/path_kind.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// The status of what is at a path; unset if nothing is there.
std::optional<FileStatus> found_at(const fs::path& path) {
  if (const auto status = status_of(path)) return status;
  if (is_absence(errno)) return std::nullopt;
  throw InputError(utf8(path), 0, 0, std::string("cannot be looked at: ") + std::strerror(errno));
}

}  // namespace

PathKind path_kind(const fs::path& path) {
  const auto status = found_at(path);
  return status ? status->kind : PathKind::Absent;
}

bool is_there(const fs::path& path) {
  return path_kind(path) != PathKind::Absent;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  const auto first = found_at(a);
  const auto second = found_at(b);
  return first && second && first->identity == second->identity;
}

}  // namespace mocapress
