// SPDX-License-Identifier: MIT
#include "core/base/open_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace mocapress {
namespace {

PathKind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return PathKind::File;
  return S_ISDIR(mode) ? PathKind::Folder : PathKind::Other;
}

FileStatus status_from(const struct stat& found) {
#ifdef __APPLE__  // not tested
  const timespec& written = found.st_mtimespec;
#else
  const timespec& written = found.st_mtim;
#endif
  return {kind_of(found.st_mode),
          static_cast<std::uint64_t>(found.st_size),
          {static_cast<std::uint64_t>(found.st_dev), found.st_ino},
          std::int64_t{written.tv_sec} * 1'000'000'000 + written.tv_nsec};
}

}  // namespace

std::optional<FileStatus> status_of(const std::filesystem::path& path) {
  struct stat found;
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  return status_from(found);
}

std::optional<FileStatus> status_of(int file) {
  struct stat found;
  if (::fstat(file, &found) != 0) return std::nullopt;
  return status_from(found);
}

bool is_absence(int error) {
  return error == ENOENT || error == ENOTDIR;
}

FileDescriptor open_existing(const std::filesystem::path& path) {
  // Without O_NONBLOCK, opening a pipe would wait for its writer.
  return FileDescriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
}

FileDescriptor open_appended(const std::filesystem::path& path, Appending to) {
  constexpr int kHow = O_RDWR | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  const int create = to == Appending::ToNew ? O_CREAT | O_EXCL : 0;
  return FileDescriptor(::open(path.c_str(), kHow | create, 0666));
}

int lock_now(int file) {
  return ::flock(file, LOCK_EX | LOCK_NB);
}

bool cut_to(int file, std::uint64_t size) {
  return ::ftruncate(file, static_cast<off_t>(size)) == 0;
}

bool remove_file(const std::filesystem::path& path) {
  return ::unlink(path.c_str()) == 0;
}

bool make_folder(const std::filesystem::path& folder) {
  return ::mkdir(folder.c_str(), 0777) == 0;
}

std::optional<std::filesystem::path> real_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? std::nullopt : std::optional(std::move(real));
}

std::string name_key(std::string_view name) {
  return std::string(name);
}

bool synchronise_folder_of(const std::filesystem::path& file) {
  const FileDescriptor folder = open_folder_of(file);
  return folder && synchronise_folder(folder.number());
}

}  // namespace mocapress
