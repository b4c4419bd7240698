// SPDX-License-Identifier: MIT
#include "core/base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

MappedFile::MappedFile(const std::filesystem::path& path, bool beforehand) {
  std::optional<MappedFile> mapped = of_descriptor(open_to_read(path).number(), beforehand);
  if (!mapped)
    throw InputError(utf8(path), 0, 0, std::string("cannot be read: ") + std::strerror(errno));
  std::swap(bytes_, mapped->bytes_);
}

std::optional<MappedFile> MappedFile::of_descriptor(int file, bool beforehand) {
  struct stat status;
  if (::fstat(file, &status) != 0) return std::nullopt;
  const auto size = static_cast<std::size_t>(status.st_size);
  MappedFile mapped;
  if (size == 0) return mapped;
#ifdef MAP_POPULATE
  const int flags = MAP_PRIVATE | (beforehand ? MAP_POPULATE : 0);
#else  // macOS: pages are loaded on first access
  const int flags = MAP_PRIVATE;
  static_cast<void>(beforehand);
#endif
  void* const memory = ::mmap(nullptr, size, PROT_READ, flags, file, 0);
  if (memory == MAP_FAILED) return std::nullopt;
  mapped.bytes_ = {static_cast<const std::byte*>(memory), size};
  return mapped;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace mocapress
