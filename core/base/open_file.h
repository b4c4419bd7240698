// SPDX-License-Identifier: MIT
// Files as the system has them, with one body for POSIX and one for Windows: the only places,
// beside staged_file.cpp and mapped_file.cpp, that call the system. Failures are errno values.
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

/// The file at the end of a path's links, or open under a number. Unset: errno tells why.
std::optional<FileStatus> status_of(const std::filesystem::path& path);
std::optional<FileStatus> status_of(int file);

/// Returns whether an error means that nothing is at a path. After any other error this is unknown.
bool is_absence(int error);

/// Opens what is there for reading, and waits for nothing if that is a pipe. Nothing opened: errno.
FileDescriptor open_existing(const std::filesystem::path& path);

enum class Appending { ToExisting, ToNew };

/// Opens a file for reading and appending. ToNew fails with EEXIST if something is there.
FileDescriptor open_appended(const std::filesystem::path& path, Appending to);

/// Locks an open file against everyone else, as flock(2) with LOCK_EX and LOCK_NB does: 0, or -1
/// and EWOULDBLOCK while another holds the lock. Others can still read the file.
int lock_now(int file);

/// Reads from `offset` until `count` bytes or the end of the file, and returns the number of bytes
/// read. Unset: errno.
std::optional<std::size_t> read_all(int file, std::uint64_t offset, char* bytes, std::size_t count);

// These return whether they succeeded; errno tells why not.

bool cut_to(int file, std::uint64_t size);
bool remove_file(const std::filesystem::path& path);
bool make_folder(const std::filesystem::path& folder);  // EEXIST if anything is there

/// Waits until the names in the folder that contains `file` are on the disk.
bool synchronise_folder_of(const std::filesystem::path& file);

}  // namespace mocapress
