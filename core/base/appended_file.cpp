// SPDX-License-Identifier: MIT
#include "core/base/appended_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace mocapress {
namespace {

namespace fs = std::filesystem;

bool synchronise_folder_of(const fs::path& file) {
  const FileDescriptor folder = open_folder_of(file);
  return folder && synchronise_folder(folder.number());
}

}  // namespace

AppendedFile::AppendedFile(fs::path path) : AppendedFile(std::move(path), &::flock) {}

AppendedFile::AppendedFile(fs::path path, Lock lock)
    : path_(std::move(path)), target_(end_of_links(path_)), lock_(lock) {
  open();
}

AppendedFile::~AppendedFile() {
  struct stat found;
  const bool empty = ::fstat(file_.number(), &found) == 0 && found.st_size == 0;
  try {
    if (made_ && empty && is_at(file_.number(), target_)) ::unlink(target_.c_str());
  } catch (const InputError&) {
    // An empty file may stay; it does no harm.
  }
}

/// The file that is at the place once it is locked: another process may have replaced it between.
void AppendedFile::open() {
  Opened opened;
  do {
    opened = open_at_its_place();
    take_lock(opened.file.number());
  } while (!is_at(opened.file.number(), target_));
  struct stat found;
  if (::fstat(opened.file.number(), &found) != 0) fail(errno);
  file_ = std::move(opened.file);
  made_ = made_ || opened.made;
  size_ = static_cast<std::uint64_t>(found.st_size);
}

AppendedFile::Opened AppendedFile::open_at_its_place() const {
  constexpr int kHow = O_RDWR | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  struct stat found;
  const bool is_found = ::stat(target_.c_str(), &found) == 0;
  if (!is_found && errno != ENOENT) fail(errno);
  if (is_found && !S_ISREG(found.st_mode))
    throw WriteError(path_.string() + ": is not a regular file");
  FileDescriptor there(::open(target_.c_str(), kHow));
  if (there) return {std::move(there), false};
  if (errno != ENOENT) fail(errno);
  FileDescriptor made(::open(target_.c_str(), kHow | O_CREAT | O_EXCL, 0666));
  if (!made && errno == EEXIST) return open_at_its_place();
  if (!made) fail(errno);
  return {std::move(made), true};
}

void AppendedFile::take_lock(int file) {
  while (lock_(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK) throw InUse(path_.string() + ": another run is using it");
    warning_ = cannot_be_locked(path_, errno);
    return;
  }
}

std::string AppendedFile::read(std::uint64_t offset, std::size_t length) const {
  std::string text(length, '\0');
  if (!read_all(file_.number(), offset, text))
    throw InputError(path_.string(), 0, 0, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

void AppendedFile::append(std::string_view line) {
  std::string text(line);
  text += '\n';
  const bool needs_name = made_ && size_ == 0;
  if (write_all(file_.number(), text) && synchronise(file_.number()) &&
      (!needs_name || synchronise_folder_of(target_))) {
    size_ += text.size();
    return;
  }
  const int why = errno;
  // Half a line would spoil the next. Without a lock the end of the file may be somebody else's.
  if (!warning_ && ::ftruncate(file_.number(), static_cast<off_t>(size_)) != 0) fail(errno);
  fail(why);
}

void AppendedFile::replace(const std::function<void(StagedFile&)>& write) {
  StagedFile file(target_);
  write(file);
  file.commit();
  open();  // the old file is released only then
}

void AppendedFile::fail(int error) const {
  throw WriteError(path_.string() + ": cannot be written: " + std::strerror(error));
}

}  // namespace mocapress
