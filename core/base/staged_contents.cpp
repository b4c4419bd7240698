// SPDX-License-Identifier: MIT
// Functions of staged_file.h that are the same on POSIX and Windows.
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/staged_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

bool read_all(int file, std::uint64_t offset, std::string& bytes) {
  const auto got = read_all(file, offset, bytes.data(), bytes.size());
  if (got) bytes.resize(*got);
  return got.has_value();
}

Warning cannot_be_locked(const std::filesystem::path& path, int error) {
  return {utf8(path), 0,
          std::string("cannot be locked (") + std::strerror(error) +
              "): make sure that no other run is at work on it"};
}

void StagedFile::write(std::span<const std::byte> bytes) {
  write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void StagedFile::write(std::string_view text) {
  if (!write_all(file_.number(), text)) fail(errno);
}

std::vector<std::byte> StagedFile::read_back() const {
  const std::optional<FileStatus> now = status_of(file_.number());
  if (!now) fail(errno);
  std::vector<std::byte> bytes(now->size);
  const auto got = read_all(file_.number(), 0, reinterpret_cast<char*>(bytes.data()), bytes.size());
  if (!got || *got < bytes.size()) fail(got ? EIO : errno);
  return bytes;
}

MappedFile StagedFile::map_back() const {
  std::optional<MappedFile> mapped = MappedFile::of_descriptor(file_.number());
  if (!mapped) fail(errno);
  return std::move(*mapped);
}

void StagedFile::fail(int error) const {
  throw WriteError(utf8(path_) + ": cannot be written: " + std::strerror(error));
}

void StagedFile::fail_in_place(int error) const {
  throw WriteError(
      utf8(path_) +
      ": is written, but a power cut may undo it: its folder cannot be synchronised: " +
      std::strerror(error));
}

}  // namespace mocapress
