// SPDX-License-Identifier: MIT
#include "core/batch/input_stamp.h"

#include <fstream>

#include "core/base/error.h"
#include "core/base/fnv1a.h"
#include "core/formats/motion_file.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const BatchItem& item) {
  const fs::path input = item.input;
  if (!equals_ignoring_case(input.extension().string(), ".amc")) return {input};
  return {input, item.skeleton.empty() ? find_skeleton(input) : fs::path(item.skeleton)};
}

void add_file(Fnv1a& hash, const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string buffer(1 << 16, '\0');
  while (stream) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    hash.add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (!stream.eof()) throw InputError(file.string(), 0, 0, "cannot be read");
}

/// Without the hash.
InputStamp quick_stamp(const std::vector<fs::path>& files) {
  InputStamp quick;
  for (const fs::path& file : files) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    const fs::file_time_type written =
        error ? fs::file_time_type() : fs::last_write_time(file, error);
    if (error) throw InputError(file.string(), 0, 0, error.message());
    quick.bytes += bytes;
    const auto time = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::file_clock::to_sys(written).time_since_epoch());
    quick.newest_ns = std::max(quick.newest_ns, std::int64_t{time.count()});
  }
  return quick;
}

std::string hash_of_all(const std::vector<fs::path>& files) {
  Fnv1a hash;
  for (const fs::path& file : files) add_file(hash, file);
  return hash.text();
}

}  // namespace

InputStamp stamp(const BatchItem& item) {
  const std::vector<fs::path> files = files_of(item);
  InputStamp whole = quick_stamp(files);
  whole.hash = hash_of_all(files);
  return whole;
}

bool unchanged(const BatchItem& item, const InputStamp& stamp) {
  try {
    const std::vector<fs::path> files = files_of(item);
    const InputStamp quick = quick_stamp(files);
    if (quick.bytes != stamp.bytes) return false;
    return quick.newest_ns == stamp.newest_ns || hash_of_all(files) == stamp.hash;
  } catch (const InputError&) {
    return false;
  }
}

std::string hash_of(const fs::path& file) {
  return hash_of_all({file});
}

}  // namespace mocapress
