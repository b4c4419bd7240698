// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The characters that a batch's clips are put on. A file is parsed once, and again only if its
/// size or time has changed. Several threads may ask for it at once: one parses, the others wait.
class SharedCharacters {
 public:
  /// Returns the character that read_character() reads from the file. Throws InputError.
  std::shared_ptr<const Character> read(const std::filesystem::path& file);

 private:
  struct Parsed {
    std::shared_ptr<const Character> character;
    std::uint64_t bytes = 0;  // size of the file
    std::int64_t written_ns = 0;
  };

  std::mutex mutex_;
  std::map<std::filesystem::path, Parsed> parsed_;
};

}  // namespace mocapress
