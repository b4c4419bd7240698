// SPDX-License-Identifier: MIT
#include "core/base/mapped_file.h"

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"
#include "core/base/windows/system.h"

namespace mocapress {

MappedFile::MappedFile(const std::filesystem::path& path, bool beforehand) {
  std::optional<MappedFile> mapped = of_descriptor(open_to_read(path).number(), beforehand);
  if (!mapped)
    throw InputError(utf8(path), 0, 0, std::string("cannot be read: ") + std::strerror(errno));
  std::swap(bytes_, mapped->bytes_);
}

std::optional<MappedFile> MappedFile::of_descriptor(int file, bool beforehand) {
  const std::optional<FileStatus> status = status_of(file);
  if (!status) return std::nullopt;
  MappedFile mapped;
  if (status->size == 0) return mapped;
  const HANDLE mapping =
      ::CreateFileMappingW(windows::handle_of(file), nullptr, PAGE_READONLY, 0, 0, nullptr);
  const void* const memory = mapping ? ::MapViewOfFile(mapping, FILE_MAP_READ, 0, 0, 0) : nullptr;
  if (!memory) windows::failed();
  if (mapping) ::CloseHandle(mapping);  // the view stays valid
  if (!memory) return std::nullopt;
  mapped.bytes_ = {static_cast<const std::byte*>(memory), status->size};
  constexpr std::size_t kPage = 4096;
  if (beforehand)
    for (std::size_t at = 0; at < mapped.bytes_.size(); at += kPage)
      static_cast<void>(*static_cast<const volatile std::byte*>(&mapped.bytes_[at]));
  return mapped;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::UnmapViewOfFile(bytes_.data());
}

}  // namespace mocapress
