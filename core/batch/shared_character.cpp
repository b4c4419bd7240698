// SPDX-License-Identifier: MIT
#include "core/batch/shared_character.h"

#include <system_error>

#include "core/base/error.h"

namespace mocapress {

namespace fs = std::filesystem;

std::shared_ptr<const Character> SharedCharacter::read(const fs::path& file) {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  const fs::file_time_type written =
      error ? fs::file_time_type() : fs::last_write_time(file, error);
  if (error) throw InputError(file.string(), 0, 0, error.message());
  if (!character_ || file != file_ || bytes != bytes_ || written != written_) {
    character_ = nullptr;
    character_ = std::make_shared<const Character>(read_character(file));
    file_ = file;
    bytes_ = bytes;
    written_ = written;
  }
  return character_;
}

}  // namespace mocapress
