// SPDX-License-Identifier: MIT
#include "core/base/open_file.h"

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/utf8_path.h"
#include "core/base/windows/system.h"

namespace mocapress {

namespace fs = std::filesystem;

namespace windows {

bool failed() {
  switch (::GetLastError()) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_INVALID_NAME:  // a name that no file can have, such as one with a question mark
    case ERROR_BAD_PATHNAME:
      errno = ENOENT;
      break;
    case ERROR_DIRECTORY:
      errno = ENOTDIR;
      break;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      errno = EACCES;
      break;
    case ERROR_WRITE_PROTECT:
      errno = EROFS;
      break;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      errno = EEXIST;
      break;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      errno = ENOSPC;
      break;
    case ERROR_TOO_MANY_OPEN_FILES:
      errno = EMFILE;
      break;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
      errno = ENOMEM;
      break;
    case ERROR_FILENAME_EXCED_RANGE:
      errno = ENAMETOOLONG;
      break;
    case ERROR_INVALID_FUNCTION:
    case ERROR_NOT_SUPPORTED:
      errno = ENOSYS;
      break;
    case ERROR_INVALID_HANDLE:
      errno = EBADF;
      break;
    default:
      errno = EIO;
  }
  return false;
}

HANDLE handle_of(int file) {
  return file < 0 ? INVALID_HANDLE_VALUE : reinterpret_cast<HANDLE>(::_get_osfhandle(file));
}

std::wstring system_path(const fs::path& path) {
  constexpr std::size_t kLongest = 240;  // leaves room for names below a folder
  const DWORD size = ::GetFullPathNameW(path.c_str(), 0, nullptr, nullptr);
  std::wstring full(size, L'\0');
  full.resize(::GetFullPathNameW(path.c_str(), size, full.data(), nullptr));
  if (full.size() < kLongest || full.starts_with(L"\\\\?\\") || full.starts_with(L"\\\\.\\"))
    return full;
  return full.starts_with(L"\\\\") ? L"\\\\?\\UNC" + full.substr(1) : L"\\\\?\\" + full;
}

FileDescriptor opened(const fs::path& path, DWORD access, DWORD creation, DWORD flags) {
  constexpr DWORD kAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE handle =
      ::CreateFileW(system_path(path).c_str(), access, kAll, nullptr, creation, flags, nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    failed();
    return FileDescriptor();
  }
  FileDescriptor file(::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY));
  if (!file) ::CloseHandle(handle);
  return file;
}

}  // namespace windows

using windows::failed;
using windows::handle_of;
using windows::opened;
using windows::system_path;

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::_close(number_);
}

std::optional<FileStatus> status_of(const fs::path& path) {
  const FileDescriptor file =
      opened(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  return file ? status_of(file.number()) : std::nullopt;
}

std::optional<FileStatus> status_of(int file) {
  const HANDLE handle = handle_of(file);
  if (::GetFileType(handle) != FILE_TYPE_DISK) {
    if (handle != INVALID_HANDLE_VALUE) return FileStatus{PathKind::Other, 0, {}};
    errno = EBADF;
    return std::nullopt;
  }
  BY_HANDLE_FILE_INFORMATION found;
  if (!::GetFileInformationByHandle(handle, &found)) {
    failed();
    return std::nullopt;
  }
  const auto both = [](DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; };
  // Tenths of a microsecond since 1601.
  const auto written = static_cast<std::int64_t>(
      both(found.ftLastWriteTime.dwHighDateTime, found.ftLastWriteTime.dwLowDateTime));
  constexpr std::int64_t kBegin1970 = 116'444'736'000'000'000;
  const bool is_folder = (found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  return FileStatus{is_folder ? PathKind::Folder : PathKind::File,
                    both(found.nFileSizeHigh, found.nFileSizeLow),
                    {found.dwVolumeSerialNumber, both(found.nFileIndexHigh, found.nFileIndexLow)},
                    (written - kBegin1970) * 100};
}

bool is_absence(int error) {
  return error == ENOENT || error == ENOTDIR;
}

FileDescriptor open_existing(const fs::path& path) {
  // "Backup semantics" lets folders be opened too; the caller distinguishes them from files.
  return opened(path, GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
}

FileDescriptor open_appended(const fs::path& path, Appending to) {
  return opened(path, GENERIC_READ | GENERIC_WRITE,
                to == Appending::ToNew ? CREATE_NEW : OPEN_EXISTING);
}

int lock_now(int file) {
  // Locks a byte beyond the end of any file, since others cannot read a locked byte.
  OVERLAPPED place{};
  place.OffsetHigh = 0x40000000;
  constexpr DWORD kHow = LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY;
  if (::LockFileEx(handle_of(file), kHow, 0, 1, 0, &place)) return 0;
  const DWORD error = ::GetLastError();
  failed();
  if (error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING) errno = EWOULDBLOCK;
  return -1;
}

bool cut_to(int file, std::uint64_t size) {
  FILE_END_OF_FILE_INFO end;
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
  return ::SetFileInformationByHandle(handle_of(file), FileEndOfFileInfo, &end, sizeof end) ||
         failed();
}

bool remove_file(const fs::path& path) {
  return ::DeleteFileW(system_path(path).c_str()) || failed();
}

bool make_folder(const fs::path& folder) {
  if (::CreateDirectoryW(system_path(folder).c_str(), nullptr)) return true;
  failed();
  const int error = errno;
  errno =
      status_of(folder) ? EEXIST : error;  // the root of a drive only says that access is denied
  return false;
}

/// By its documentation Windows has no limit of 260 characters here; Wine 8 has one.
std::optional<fs::path> real_path(const fs::path& path) {
  const FileDescriptor end = opened(path, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  if (!end) return std::nullopt;
  std::wstring found(32768, L'\0');  // longer than any path
  const DWORD size = ::GetFinalPathNameByHandleW(handle_of(end.number()), found.data(),
                                                 static_cast<DWORD>(found.size()), 0);
  if (size == 0 || size >= found.size()) return std::nullopt;
  found.resize(size);
  // Drops the prefix, since fs::path finds no root in it. system_path() adds it again.
  constexpr std::wstring_view kLong = L"\\\\?\\";
  constexpr std::wstring_view kShare = L"\\\\?\\UNC\\";
  if (found.starts_with(kShare)) return found.replace(0, kShare.size(), L"\\\\");
  return found.starts_with(kLong) ? found.substr(kLong.size()) : found;
}

std::string name_key(std::string_view name) {
  std::wstring letters = utf8_path(name).native();
  // Without further flags, this call uses the file system's rules for upper case.
  ::LCMapStringEx(LOCALE_NAME_INVARIANT, LCMAP_UPPERCASE, letters.data(),
                  static_cast<int>(letters.size()), letters.data(),
                  static_cast<int>(letters.size()), nullptr, nullptr, 0);
  return utf8(letters);
}

bool synchronise_folder_of(const fs::path&) {
  return true;  // Windows has no call for this; names are in the file system's journal
}

bool write_all(int file, std::string_view bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  while (!bytes.empty()) {
    // This offset means the end of the file, wherever the last read has moved the position.
    OVERLAPPED end{};
    end.Offset = end.OffsetHigh = 0xffffffff;
    DWORD written = 0;
    const auto count = static_cast<DWORD>(std::min(bytes.size(), kMost));
    if (!::WriteFile(handle_of(file), bytes.data(), count, &written, &end)) return failed();
    bytes.remove_prefix(written);
  }
  return true;
}

std::optional<std::size_t> read_all(int file, std::uint64_t offset, char* bytes,
                                    std::size_t count) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  std::size_t done = 0;
  while (done < count) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(offset + done);
    place.OffsetHigh = static_cast<DWORD>((offset + done) >> 32);
    DWORD got = 0;
    const auto wanted = static_cast<DWORD>(std::min(count - done, kMost));
    if (!::ReadFile(handle_of(file), bytes + done, wanted, &got, &place)) {
      if (::GetLastError() == ERROR_HANDLE_EOF) break;
      failed();
      return std::nullopt;
    }
    if (got == 0) break;
    done += got;
  }
  return done;
}

bool synchronise(int file) {
  return ::FlushFileBuffers(handle_of(file)) || failed() || errno == ENOSYS;
}

bool is_at(int file, const fs::path& place) {
  const auto opened_file = status_of(file);
  const auto there = opened_file ? status_of(place) : std::nullopt;
  if (there) return there->identity == opened_file->identity;
  if (is_absence(errno)) return false;
  throw InputError(utf8(place), 0, 0, std::string("cannot be looked at: ") + std::strerror(errno));
}

}  // namespace mocapress
