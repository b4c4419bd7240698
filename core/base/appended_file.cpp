// SPDX-License-Identifier: MIT
#include "core/base/appended_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {

namespace fs = std::filesystem;

AppendedFile::AppendedFile(fs::path path) : AppendedFile(std::move(path), &lock_now) {}

AppendedFile::AppendedFile(fs::path path, Lock lock)
    : path_(std::move(path)), target_(end_of_links(path_)), lock_(lock) {
  open();
}

AppendedFile::~AppendedFile() {
  if (!made_) return;
  const std::optional<FileStatus> now = status_of(file_.number());
  try {
    if (now && now->size == 0 && is_at(file_.number(), target_)) remove_file(target_);
  } catch (const InputError&) {
    // An empty file that cannot be looked at stays; it does no harm.
  }
}

/// Opens and locks the file at the path. Repeats if another process replaced the file before it was
/// locked.
void AppendedFile::open() {
  Opened opened;
  do {
    opened = open_at_its_place();
    take_lock(opened.file.number());
  } while (!is_at(opened.file.number(), target_));
  const std::optional<FileStatus> found = status_of(opened.file.number());
  if (!found) fail(errno);
  file_ = std::move(opened.file);
  made_ = made_ || opened.made;
  size_ = found->size;
}

AppendedFile::Opened AppendedFile::open_at_its_place() const {
  const std::optional<FileStatus> found = status_of(target_);
  if (!found && errno != ENOENT) fail(errno);
  if (found && found->kind != PathKind::File)
    throw WriteError(utf8(path_) + ": is not a regular file");
  FileDescriptor there = open_appended(target_, Appending::ToExisting);
  if (there) return {std::move(there), false};
  if (errno != ENOENT) fail(errno);
  FileDescriptor made = open_appended(target_, Appending::ToNew);
  if (!made && errno == EEXIST) return open_at_its_place();
  if (!made) fail(errno);
  return {std::move(made), true};
}

void AppendedFile::take_lock(int file) {
  while (lock_(file) != 0) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK) throw InUse(utf8(path_) + ": another run is using it");
    warning_ = cannot_be_locked(path_, errno);
    return;
  }
}

std::string AppendedFile::read(std::uint64_t offset, std::size_t length) const {
  std::string text(length, '\0');
  if (!read_all(file_.number(), offset, text))
    throw InputError(utf8(path_), 0, 0, std::string("cannot be read: ") + std::strerror(errno));
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
  // Half a line would spoil the next one, so it is cut off. Without a lock this could cut off lines
  // of another process.
  if (!warning_ && !cut_to(file_.number(), size_)) fail(errno);
  fail(why);
}

void AppendedFile::replace(const std::function<void(StagedFile&)>& write) {
  StagedFile file(target_);
  write(file);
  file.commit();
  open();  // opens and locks the new file, and only then releases the old one
}

void AppendedFile::fail(int error) const {
  throw WriteError(utf8(path_) + ": cannot be written: " + std::strerror(error));
}

}  // namespace mocapress
