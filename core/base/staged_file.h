// SPDX-License-Identifier: MIT
// Writes a file whole or not at all, by open(2) with O_TMPFILE, rename(2) and fsync(2). All files
// are written by this class, except that AppendedFile appends to its own.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/mapped_file.h"

namespace mocapress {

/// A file or folder held open, closed at the end.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor();

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

// The following functions return whether they succeeded; errno tells why not.

/// Writes all bytes, even if the system takes them in parts.
bool write_all(int file, std::string_view bytes);

/// Reads from `offset` until `bytes` is full or the file ends. Then shortens `bytes` to what was
/// read.
bool read_all(int file, std::uint64_t offset, std::string& bytes);

/// Waits until the contents are on the disk. Succeeds on file systems that have nothing to
/// synchronise.
bool synchronise(int file);

/// Opens the folder that contains or will contain `file`. It need not be readable.
FileDescriptor open_folder_of(const std::filesystem::path& file);

/// Waits until the names in an open folder are on the disk.
bool synchronise_folder(int folder);

/// A file that appears at its path, its "place", whole or not at all. After any failure, such as a
/// full disk, a kill or a power cut, the place has the old file or the new one. Nothing else is
/// left behind, except if a kill or power cut comes while the file has its random name.
///
/// Until commit() the file has no name; commit() gives it a random name for an instant. On file
/// systems without unnamed files it has a random name from the start, hidden in the folder of its
/// place. It is newly created under that name: neither an existing file nor a link is ever reused.
///
/// If something is at the place already:
/// - A file is replaced. The new file gets its permissions, and its owner and group if the process
///   may set them. Without an old file, the permissions are those of the umask.
/// - A link stays, and the file it points to is written. A link that somebody else put into a
///   folder where everyone may write, such as /tmp, is refused.
/// - A file that is write-protected, a folder, a device and the like are refused.
class StagedFile {
 public:
  enum class Existing { Replace, Refuse };
  enum class Temporary { Unnamed, Named };  // Unnamed: where possible

  /// Throws WriteError, like all members.
  explicit StagedFile(std::filesystem::path path, Temporary temporary = Temporary::Unnamed);
  StagedFile(StagedFile&&) noexcept = default;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Removes the file unless it was committed.
  ~StagedFile();

  /// The path that was given; may be a link.
  const std::filesystem::path& path() const { return path_; }

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Overwrites earlier contents from `offset` on.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);

  /// Everything written so far, as the file system returns it.
  std::vector<std::byte> read_back() const;

  /// Like read_back(), but as a mapped file, for large contents.
  MappedFile map_back() const;

  /// Waits until the contents are on the disk, puts the file in place, and waits until its name is
  /// on the disk. Call it once, after everything else. If only the last step fails, the file is in
  /// place, and the WriteError says that a power cut may undo it.
  void commit(Existing existing = Existing::Replace);

  /// Commits many files, which wait for the disk together: twice in total, not twice each. If a
  /// file cannot be put in place, the files before it are removed again, except those that replaced
  /// a file. So with Existing::Refuse either all files are in place or none.
  static void commit_all(std::span<StagedFile> files, Existing existing = Existing::Replace);

 private:
  static void synchronise_all(std::span<StagedFile> files, bool names);
  void open_unnamed(std::uint32_t mode);
  void open_named(std::uint32_t mode);
  void give_name();
  void take_place(Existing existing);
  void leave_place(Existing existing) const;
  [[noreturn]] void fail(int error) const;
  [[noreturn]] void fail_in_place(int error) const;

  std::filesystem::path path_;
  std::filesystem::path place_;  // name in the folder; on Windows the whole path
  FileDescriptor folder_;        // stays the same folder even if it is renamed
  FileDescriptor file_;
  std::string name_;  // the random name; empty: it has none
  bool replaces_;     // true: a file is at the place already
};

/// True if an open file is still the file at a place; false if it was replaced or removed. Throws
/// InputError if the system cannot tell.
bool is_at(int file, const std::filesystem::path& place);

/// Warns that a file is not locked against other processes; `error` is the errno value of the
/// attempt.
Warning cannot_be_locked(const std::filesystem::path& path, int error);

/// The file that writing to `path` writes: the end of the path's links. Throws WriteError.
std::filesystem::path end_of_links(const std::filesystem::path& path);

}  // namespace mocapress
