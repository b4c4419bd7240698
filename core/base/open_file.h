// SPDX-License-Identifier: MIT
// Calls of the operating system for files, with one implementation for POSIX and one for Windows.
// Failures are errno values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/file_identity.h"
#include "core/base/path_kind.h"
#include "core/base/staged_file.h"

namespace mocapress {

struct FileStatus {
  PathKind kind = PathKind::Absent;
  std::uint64_t size = 0;
  FileIdentity identity;
  std::int64_t written_ns = 0;  // last change of the contents, since 1970
};

/// Describes a file: the one at the end of a path's links, or an open one. Unset on failure; errno
/// tells why.
std::optional<FileStatus> status_of(const std::filesystem::path& path);
std::optional<FileStatus> status_of(int file);

/// True if an errno value means that nothing is at a path. After any other error that is unknown.
bool is_absence(int error);

/// Opens whatever is at a path for reading. Does not wait if that is a pipe. The result is empty on
/// failure; errno tells why.
FileDescriptor open_existing(const std::filesystem::path& path);

enum class Appending { ToExisting, ToNew };

/// Opens a file for reading and appending. ToNew creates the file, and fails with EEXIST if
/// anything is at the path.
FileDescriptor open_appended(const std::filesystem::path& path, Appending to);

/// Locks an open file against everyone else, as flock(2) with LOCK_EX and LOCK_NB does. Returns 0,
/// or -1 with errno EWOULDBLOCK while another holds the lock. Others can still read the file.
int lock_now(int file);

/// Reads from `offset` until `count` bytes or the end of the file, and returns the number of bytes
/// read. Unset on failure; errno tells why.
std::optional<std::size_t> read_all(int file, std::uint64_t offset, char* bytes, std::size_t count);

// The following functions return whether they succeeded; errno tells why not.

bool cut_to(int file, std::uint64_t size);
bool remove_file(const std::filesystem::path& path);
bool make_folder(const std::filesystem::path& folder);  // EEXIST if anything is there

/// Waits until the names in the folder that contains `file` are on the disk.
bool synchronise_folder_of(const std::filesystem::path& file);

}  // namespace mocapress
