// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "core/formats/motion_file.h"

namespace mocapress {

/// The characters that the clips of a batch are put on. A file is parsed once, and again only where
/// its size or time of writing changed. Threads may ask at once: one parses, the others wait.
class SharedCharacters {
 public:
  /// Returns what read_character() returns for the file. Throws InputError.
  std::shared_ptr<const Character> read(const std::filesystem::path& file);

 private:
  struct Parsed {
    std::shared_ptr<const Character> character;
    std::uint64_t bytes = 0;  // the file's
    std::int64_t written_ns = 0;
  };

  std::mutex mutex_;
  std::map<std::filesystem::path, Parsed> parsed_;
};

}  // namespace mocapress
