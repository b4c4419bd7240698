// SPDX-License-Identifier: MIT
#include "core/batch/shared_characters.h"

#include <system_error>

#include "core/base/error.h"

namespace mocapress {

namespace fs = std::filesystem;

std::shared_ptr<const Character> SharedCharacters::read(const fs::path& file) {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  const fs::file_time_type written =
      error ? fs::file_time_type() : fs::last_write_time(file, error);
  if (error) throw InputError(file.string(), 0, 0, error.message());
  Parsed& parsed = parsed_[file];
  if (!parsed.character || bytes != parsed.bytes || written != parsed.written) {
    parsed.character = nullptr;
    parsed.character = std::make_shared<const Character>(read_character(file));
    parsed.bytes = bytes;
    parsed.written = written;
  }
  return parsed.character;
}

}  // namespace mocapress
