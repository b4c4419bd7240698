// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The character that the clips of a batch are put on. Its file is parsed once, and again only
/// where another one is asked for or its size or time of writing changed. Threads may ask at once:
/// one parses, the others wait.
class SharedCharacter {
 public:
  /// As read_character(). Throws InputError.
  std::shared_ptr<const Character> read(const std::filesystem::path& file);

 private:
  std::mutex mutex_;
  std::shared_ptr<const Character> character_;  // of the file below; null: none was read yet
  std::filesystem::path file_;
  std::uintmax_t bytes_ = 0;
  std::filesystem::file_time_type written_;
};

}  // namespace mocapress
