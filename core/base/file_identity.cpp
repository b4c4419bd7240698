// SPDX-License-Identifier: MIT
#include "core/base/file_identity.h"

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
  if (const auto found = status_of(path)) return found->identity;
  if (is_absence(errno)) return std::nullopt;
  throw InputError(utf8(path), 0, 0, std::strerror(errno));
}

void refuse_source(const std::filesystem::path& place,
                   const std::vector<std::filesystem::path>& sources) {
  const std::optional<FileIdentity> there = identity_of(place);
  if (!there) return;
  for (const std::filesystem::path& source : sources)
    if (identity_of(source) == there)
      throw WriteError(utf8(place) + ": is one of the inputs: not overwritten");
}

}  // namespace mocapress
