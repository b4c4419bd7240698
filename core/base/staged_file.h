// SPDX-License-Identifier: MIT
// The one way to write a file. After open(2) on O_TMPFILE, rename(2) and fsync(2).

#pragma once

#include <sys/types.h>
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

/// A file or folder that the system holds open for us; closed at the end.
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

// These answer whether it went well; errno says why not.

/// Writes everything, however often the system takes only a part.
bool write_all(int file, std::string_view bytes);

/// Reads from `offset` on until `bytes` is full or the file ends, to which `bytes` is then cut.
bool read_all(int file, std::uint64_t offset, std::string& bytes);

/// Waits until the contents are on the disk. A file system that has nothing to synchronise is
/// content.
bool synchronise(int file);

/// The folder that `file` is or will be in. It need not be readable.
FileDescriptor open_folder_of(const std::filesystem::path& file);

/// Waits until the names in an open folder are on the disk.
bool synchronise_folder(int folder);

/// A file that takes its place whole or not at all. Whatever fails, a full disk, a kill or a power
/// cut, the place has the old file or the new one. Nothing else is left behind, but for a kill or a
/// power cut while the file has its random name.
///
/// Until commit() the file has no name, and in it a random one for an instant. Where the file
/// system has no files without a name, it has the random one from the start, hidden beside its
/// place, and is made there anew: neither a file nor a link is ever reused.
///
/// What is at the place already:
/// - A file keeps its permissions, and its owner and group where we may set them. A new file gets
///   those of the umask.
/// - A link stays, and what it points to is written. A link that somebody else put into a folder
///   where everyone may write, such as /tmp, is refused.
/// - A file that is write-protected, a folder, a device and the like are refused.
class StagedFile {
 public:
  enum class Existing { Replace, Refuse };
  enum class Temporary { Unnamed, Named };  // Unnamed: where the file system offers it

  /// Throws WriteError, as all of these do.
  explicit StagedFile(std::filesystem::path path, Temporary temporary = Temporary::Unnamed);
  StagedFile(StagedFile&&) noexcept = default;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Removes what was not committed.
  ~StagedFile();

  /// The place, as it was given.
  const std::filesystem::path& path() const { return path_; }

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Over what was written before, from `offset` on.
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes);

  /// All that was written, as the file system gives it back.
  std::vector<std::byte> read_back() const;

  /// The same where it lies, for what is large.
  MappedFile map_back() const;

  /// Waits until the contents are on the disk, puts the file in place, and waits until its name is
  /// on the disk. May be called once, as the last of all. Where only the last of these fails, the
  /// file is in place, and WriteError says that a power cut may undo it.
  void commit(Existing existing = Existing::Replace);

  /// The same of many files, all of which wait for the disk together: twice, not twice each. Where
  /// one cannot take its place, those before it have.
  static void commit_all(std::span<StagedFile> files, Existing existing = Existing::Replace);

 private:
  static void synchronise_all(std::span<StagedFile> files, bool names);
  void open_unnamed(mode_t mode);
  void open_named(mode_t mode);
  void give_name();
  void take_place(Existing existing);
  [[noreturn]] void fail(int error) const;
  [[noreturn]] void fail_in_place(int error) const;

  std::filesystem::path path_;
  std::string place_;      // its name in the folder
  FileDescriptor folder_;  // so that it stays the same folder whatever is renamed
  FileDescriptor file_;
  std::string name_;  // the random one; empty: it has none
};

/// Whether an open file is still the one at a place, and not one that was replaced. Throws
/// InputError where the system cannot say.
bool is_at(int file, const std::filesystem::path& place);

/// The warning that nothing keeps other processes away from a file, as flock(2) failed.
Warning cannot_be_locked(const std::filesystem::path& path, int error);

/// Where writing to `path` writes: the end of its links. Throws WriteError.
std::filesystem::path end_of_links(const std::filesystem::path& path);

}  // namespace mocapress
