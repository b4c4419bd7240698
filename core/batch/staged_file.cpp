// SPDX-License-Identifier: MIT
#include "core/batch/staged_file.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// Where the file system cannot rename without replacing, looks first.
int rename_to_free_place(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  std::error_code ignored;
  if (fs::exists(to, ignored)) {
    errno = EEXIST;
    return -1;
  }
  return std::rename(from.c_str(), to.c_str());
}

}  // namespace

StagedFile::StagedFile(fs::path path, std::span<const std::byte> bytes)
    : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  std::error_code error;
  fs::create_directories(path_.parent_path(), error);
  if (error) throw WriteError(path_.string() + ": cannot be written: " + error.message());
  std::ofstream stream(part_, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return;
  const std::string why = std::strerror(errno);
  fs::remove(part_, error);
  throw WriteError(path_.string() + ": cannot be written: " + why);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : path_(std::move(other.path_)), part_(std::exchange(other.part_, {})) {}

StagedFile::~StagedFile() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove(part_, ignored);
}

std::vector<std::byte> StagedFile::read_back() const {
  return read_bytes(part_);
}

void StagedFile::put_in_place(bool replace) {
  const int failed =
      replace ? std::rename(part_.c_str(), path_.c_str()) : rename_to_free_place(part_, path_);
  if (failed) throw WriteError(path_.string() + ": cannot be written: " + std::strerror(errno));
  part_.clear();
}

}  // namespace mocapress
