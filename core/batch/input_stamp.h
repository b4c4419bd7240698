// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/batch/batch.h"

namespace mocapress {

/// What a clip's files were when it was done: of an .amc, with its skeleton.
struct InputStamp {
  std::uintmax_t bytes = 0;
  std::int64_t newest_ns = 0;  // when the newer of them was last written
  std::string hash;            // of all their bytes

  bool operator==(const InputStamp&) const = default;
};

/// Throws InputError.
InputStamp stamp(const BatchItem& item);

/// Whether the files still are what they were. Their bytes are only read where their times differ.
bool unchanged(const BatchItem& item, const InputStamp& stamp);

/// Of a file's bytes. Throws InputError.
std::string hash_of(const std::filesystem::path& file);

}  // namespace mocapress
