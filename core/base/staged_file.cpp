// SPDX-License-Identifier: MIT
#include "core/base/staged_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __APPLE__
#include <sys/random.h>
#endif
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/open_file.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

// macOS has no unnamed files, and no call that synchronises a whole file system. This part follows
// Apple's documentation and is not tested.
#ifdef __APPLE__
constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

int rename_if_free(int folder, const char* from, const char* to) {
  return ::renameatx_np(folder, from, folder, to, RENAME_EXCL);
}

int synchronise_file_system(int) {
  return -1;
}

/// Waits until the contents are on the disk. On macOS fsync(2) may leave them in the disk's own
/// cache.
int synchronise_disk(int file) {
  return ::fcntl(file, F_FULLFSYNC) == 0 ? 0 : ::fsync(file);
}

int open_nameless(int, std::uint32_t) {
  return -1;
}
#else
constexpr int kOpenFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;

int rename_if_free(int folder, const char* from, const char* to) {
  return ::renameat2(folder, from, folder, to, RENAME_NOREPLACE);
}

int synchronise_file_system(int file) {
  return ::syncfs(file);
}

int synchronise_disk(int file) {
  return ::fsync(file);
}

int open_nameless(int folder, std::uint32_t mode) {
  return ::openat(folder, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
}
#endif

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::close(number_);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::optional<std::size_t> read_all(int file, std::uint64_t offset, char* bytes,
                                    std::size_t count) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        ::pread(file, bytes + done, count - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

bool synchronise(int file) {
  while (synchronise_disk(file) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == EOPNOTSUPP || errno == ENOSYS;
  }
  return true;
}

FileDescriptor open_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  return FileDescriptor(::open(folder.c_str(), kOpenFolder));
}

bool is_at(int file, const std::filesystem::path& place) {
  struct stat opened;
  struct stat there;
  if (::fstat(file, &opened) == 0 && ::lstat(place.c_str(), &there) == 0)
    return opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
  if (is_absence(errno)) return false;
  throw InputError(utf8(place), 0, 0, std::string("cannot be looked at: ") + std::strerror(errno));
}

bool synchronise_folder(int folder) {
  const FileDescriptor readable(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!readable) return errno == EACCES;  // a folder without read permission cannot be synchronised
  return synchronise(readable.number());
}

namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as in Linux
constexpr mode_t kNewFile = 0666;
constexpr mode_t kPrivate = 0600;
constexpr mode_t kPermissions = 0777;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw WriteError(utf8(path) + ": cannot be written: " + why);
}

/// A hidden name that nobody can guess.
std::string random_name() {
  std::array<unsigned char, 16> random;
  if (::getentropy(random.data(), random.size()) != 0) return {};
  std::string name = ".mocapress-";
  constexpr const char* kDigits = "0123456789abcdef";
  for (const unsigned char byte : random) {
    name += kDigits[byte >> 4];
    name += kDigits[byte & 15];
  }
  return name;
}

/// A path to an open file without a name, through which linkat() can give it one.
std::string link_to(int file) {
  return "/proc/self/fd/" + std::to_string(file);
}

/// True for a link that somebody else put into a folder shared by all, by Linux's rule of
/// protected_symlinks. Such a link must not decide which file is overwritten.
bool may_be_planted(const fs::path& path, const struct stat& link) {
  struct stat folder;
  const fs::path parent = path.has_parent_path() ? path.parent_path() : ".";
  if (::stat(parent.c_str(), &folder) != 0) refuse(path, std::strerror(errno));
  constexpr mode_t kShared = S_ISVTX | S_IWOTH;
  return (folder.st_mode & kShared) == kShared && link.st_uid != ::geteuid() &&
         link.st_uid != folder.st_uid;
}

/// Returns whether a file is at the place. Throws if the place must not be replaced.
bool is_replaced(const fs::path& path, const fs::path& target, struct stat& there) {
  if (::stat(target.c_str(), &there) != 0) {
    if (is_absence(errno)) return false;
    refuse(path, std::strerror(errno));
  }
  if (S_ISDIR(there.st_mode)) refuse(path, "is a folder, not a file");
  if (!S_ISREG(there.st_mode)) refuse(path, "is not a regular file");
  if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
    refuse(path, std::strerror(errno));
  return true;
}

/// Gives the new file the permissions of the old one, and its owner and group if possible. If the
/// group cannot be kept, group permissions are dropped, so that no other group gets them.
void keep_permissions(int file, const struct stat& old) {
  constexpr auto kSameOwner = static_cast<uid_t>(-1);
  mode_t mode = old.st_mode & kPermissions;
  if (::fchown(file, old.st_uid, old.st_gid) != 0 && ::fchown(file, kSameOwner, old.st_gid) != 0)
    mode &= ~static_cast<mode_t>(S_IRWXG);
  ::fchmod(file, mode);  // may fail, on a file system without permissions
}

/// Renames without replacing. If the file system cannot do that, checks for a file first and then
/// renames.
int rename_to_free_place(int folder, const char* from, const char* to) {
  if (rename_if_free(folder, from, to) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) return -1;
  if (::faccessat(folder, to, F_OK, AT_SYMLINK_NOFOLLOW) == 0) {
    errno = EEXIST;
    return -1;
  }
  if (errno != ENOENT) return -1;
  return ::renameat(folder, from, folder, to);
}

}  // namespace

fs::path end_of_links(const fs::path& path) {
  fs::path target = path;
  for (int links = 0; links < kMostLinks; ++links) {
    struct stat link;
    const bool is_found = ::lstat(target.c_str(), &link) == 0;
    if (!is_found && !is_absence(errno)) refuse(path, std::strerror(errno));
    if (!is_found || !S_ISLNK(link.st_mode)) return target;
    if (may_be_planted(target, link))
      refuse(path, "is a link that somebody else put into a folder shared by all");
    std::error_code error;
    target = target.parent_path() / fs::read_symlink(target, error);
    if (error) refuse(path, error.message());
  }
  refuse(path, std::strerror(ELOOP));
}

StagedFile::StagedFile(fs::path path, Temporary temporary) : path_(std::move(path)) {
  const fs::path target = end_of_links(path_);
  struct stat old;
  replaces_ = is_replaced(path_, target, old);
  place_ = target.filename();
  if (place_.empty()) fail(path_.empty() ? ENOENT : EISDIR);
  folder_ = open_folder_of(target);
  if (!folder_) fail(errno);
  const mode_t mode = replaces_ ? kPrivate : kNewFile;
  if (temporary == Temporary::Unnamed) open_unnamed(mode);
  if (!file_) open_named(mode);
  if (replaces_) keep_permissions(file_.number(), old);
}

StagedFile::~StagedFile() {
  if (!name_.empty()) ::unlinkat(folder_.number(), name_.c_str(), 0);
}

/// Opens a file without a name, so that nothing is left if the process is killed. Does nothing if
/// that fails: open_named() follows, and reports errors.
void StagedFile::open_unnamed(std::uint32_t mode) {
  FileDescriptor file(open_nameless(folder_.number(), mode));
  if (file && ::access(link_to(file.number()).c_str(), F_OK) == 0) file_ = std::move(file);
}

void StagedFile::open_named(std::uint32_t mode) {
  std::string name = random_name();
  file_ = FileDescriptor(::openat(folder_.number(), name.c_str(),
                                  O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
  if (!file_) fail(errno);
  name_ = std::move(name);
}

void StagedFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put =
        ::pwrite(file_.number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) fail(errno);
    offset += static_cast<std::uint64_t>(put);
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
}

void StagedFile::commit(Existing existing) {
  if (!synchronise(file_.number())) fail(errno);
  if (name_.empty()) give_name();
  take_place(existing);
  if (!synchronise_folder(folder_.number())) fail_in_place(errno);
}

void StagedFile::commit_all(std::span<StagedFile> files, Existing existing) {
  synchronise_all(files, false);
  std::size_t placed = 0;
  try {
    for (; placed < files.size(); ++placed) {
      StagedFile& file = files[placed];
      if (file.name_.empty()) file.give_name();
      file.take_place(existing);
    }
  } catch (const WriteError&) {
    for (const StagedFile& file : files.first(placed)) file.leave_place(existing);
    throw;
  }
  synchronise_all(files, true);
}

/// Synchronises contents, or names if `names`: the whole file system of the first file at once, and
/// files on other file systems one by one.
void StagedFile::synchronise_all(std::span<StagedFile> files, bool names) {
  if (files.empty()) return;
  struct stat first;
  const bool is_together = ::fstat(files.front().file_.number(), &first) == 0 &&
                           synchronise_file_system(files.front().file_.number()) == 0;
  for (const StagedFile& file : files) {
    struct stat own;
    if (is_together && ::fstat(file.file_.number(), &own) == 0 && own.st_dev == first.st_dev)
      continue;
    if (names && !synchronise_folder(file.folder_.number())) file.fail_in_place(errno);
    if (!names && !synchronise(file.file_.number())) file.fail(errno);
  }
}

void StagedFile::give_name() {
  std::string name = random_name();
  if (::linkat(AT_FDCWD, link_to(file_.number()).c_str(), folder_.number(), name.c_str(),
               AT_SYMLINK_FOLLOW) != 0)
    fail(errno);
  name_ = std::move(name);
}

void StagedFile::take_place(Existing existing) {
  const int folder = folder_.number();
  const int failed = existing == Existing::Replace
                         ? ::renameat(folder, name_.c_str(), folder, place_.c_str())
                         : rename_to_free_place(folder, name_.c_str(), place_.c_str());
  if (failed) fail(errno);
  name_.clear();
}

/// Removes the file that take_place() put in place, unless it replaced a file or was itself
/// replaced.
void StagedFile::leave_place(Existing existing) const {
  struct stat own;
  struct stat there;
  const bool is_own =
      ::fstat(file_.number(), &own) == 0 &&
      ::fstatat(folder_.number(), place_.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 &&
      own.st_dev == there.st_dev && own.st_ino == there.st_ino;
  if (is_own && (existing == Existing::Refuse || !replaces_))
    ::unlinkat(folder_.number(), place_.c_str(), 0);
}

}  // namespace mocapress
