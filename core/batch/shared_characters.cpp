// SPDX-License-Identifier: MIT
#include "core/batch/shared_characters.h"

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

namespace fs = std::filesystem;

std::shared_ptr<const Character> SharedCharacters::read(const fs::path& file) {
  const std::lock_guard lock(mutex_);
  const std::optional<FileStatus> found = status_of(file);
  if (!found) throw InputError(utf8(file), 0, 0, std::strerror(errno));
  Parsed& parsed = parsed_[file];
  if (!parsed.character || found->size != parsed.bytes || found->written_ns != parsed.written_ns) {
    parsed.character = nullptr;
    parsed.character = std::make_shared<const Character>(read_character(file));
    parsed.bytes = found->size;
    parsed.written_ns = found->written_ns;
  }
  return parsed.character;
}

}  // namespace mocapress
