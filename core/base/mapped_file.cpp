// SPDX-License-Identifier: MIT
#include "core/base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/staged_file.h"

namespace mocapress {

MappedFile::MappedFile(const std::filesystem::path& path, bool beforehand) {
  const auto refuse = [&](const char* why) {
    throw InputError(path.string(), 0, 0, std::string("cannot be read: ") + why);
  };
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status;
  if (!file || ::fstat(file.number(), &status) != 0) refuse(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) refuse("it is not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return;
  const int flags = MAP_PRIVATE | (beforehand ? MAP_POPULATE : 0);
  void* const memory = ::mmap(nullptr, size, PROT_READ, flags, file.number(), 0);
  if (memory == MAP_FAILED) refuse(std::strerror(errno));
  bytes_ = {static_cast<const std::byte*>(memory), size};
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace mocapress
