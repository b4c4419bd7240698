// SPDX-License-Identifier: MIT
#include "core/base/file_identity.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace mocapress {

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
  struct stat found;
  if (::stat(path.c_str(), &found) == 0) return FileIdentity{found.st_dev, found.st_ino};
  if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
  throw InputError(path.string(), 0, 0, std::strerror(errno));
}

void refuse_source(const std::filesystem::path& place,
                   const std::vector<std::filesystem::path>& sources) {
  const std::optional<FileIdentity> there = identity_of(place);
  if (!there) return;
  for (const std::filesystem::path& source : sources)
    if (identity_of(source) == there)
      throw WriteError(place.string() + ": is one of the inputs: not overwritten");
}

}  // namespace mocapress
