// SPDX-License-Identifier: MIT
// Until a staged file takes its place, it is marked for deletion on close, whether this process
// closes it or ends. Follows Microsoft's documentation of SetFileInformationByHandle.
#include "core/base/staged_file.h"

#include "core/base/utf8_path.h"
#include "core/base/windows/system.h"
// Included after windows.h, which it needs.
#include <aclapi.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/open_file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using windows::failed;
using windows::handle_of;
using windows::opened;
using windows::system_path;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw WriteError(utf8(path) + ": cannot be written: " + why);
}

/// A name that nobody can guess.
std::string random_name() {
  std::string name = ".mocapress-";
  constexpr const char* kDigits = "0123456789abcdef";
  std::random_device system;
  for (int i = 0; i < 4; ++i) {
    unsigned random = system();
    for (int digit = 0; digit < 8; ++digit, random >>= 4) name += kDigits[random & 15];
  }
  return name;
}

/// Returns whether a file is at the place. Throws if the place must not be replaced.
bool is_replaced(const fs::path& path, const fs::path& target) {
  const auto there = status_of(target);
  if (!there && is_absence(errno)) return false;
  if (!there) refuse(path, std::strerror(errno));
  if (there->kind == PathKind::Folder) refuse(path, "is a folder, not a file");
  if (there->kind != PathKind::File) refuse(path, "is not a regular file");
  if (::GetFileAttributesW(system_path(target).c_str()) & FILE_ATTRIBUTE_READONLY)
    refuse(path, "is write-protected");
  return true;
}

/// Gives the new file the access rights of the file at `old`. If that fails, it keeps those
/// inherited from its folder.
void keep_permissions(int file, const fs::path& old) {
  PACL allowed = nullptr;
  PSECURITY_DESCRIPTOR all = nullptr;
  if (::GetNamedSecurityInfoW(system_path(old).data(), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION,
                              nullptr, nullptr, &allowed, nullptr, &all) != ERROR_SUCCESS)
    return;
  ::SetSecurityInfo(handle_of(file), SE_FILE_OBJECT, DACL_SECURITY_INFORMATION, nullptr, nullptr,
                    allowed, nullptr);
  ::LocalFree(all);
}

/// Sets whether a file is removed when it is closed.
bool set_vanishing(int file, bool vanishing) {
  FILE_DISPOSITION_INFO wanted{};
  wanted.DeleteFile = vanishing;
  return ::SetFileInformationByHandle(handle_of(file), FileDispositionInfo, &wanted,
                                      sizeof wanted) ||
         failed();
}

/// Values of FileRenameInfo, FileRenameInfoEx and its flags, since older headers lack the latter.
constexpr auto kRename = static_cast<FILE_INFO_BY_HANDLE_CLASS>(3);
constexpr auto kRenameWithFlags = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22);
constexpr DWORD kNoFlags = 0;
constexpr DWORD kReplace = 1;
constexpr DWORD kReplaceOpenFile = 3;  // as on POSIX, programs that have the old file open keep it

bool rename_open(int file, const std::wstring& place, FILE_INFO_BY_HANDLE_CLASS how, DWORD flags) {
  const std::size_t bytes = place.size() * sizeof(wchar_t);
  std::vector<unsigned char> memory(sizeof(FILE_RENAME_INFO) + bytes);
  const auto info = reinterpret_cast<FILE_RENAME_INFO*>(memory.data());
  std::memcpy(info, &flags, sizeof flags);
  info->FileNameLength = static_cast<DWORD>(bytes);
  std::memcpy(info->FileName, place.data(), bytes);
  return ::SetFileInformationByHandle(handle_of(file), how, info,
                                      static_cast<DWORD>(memory.size())) ||
         failed();
}

/// For file systems that cannot replace an open file, such as FAT: renames the old file, which is
/// removed when its last user closes it. If the process is killed between the two renamings, the
/// old file stays under its random name.
bool push_aside(int file, const fs::path& place) {
  const FileDescriptor old = opened(place, DELETE, OPEN_EXISTING);
  const fs::path aside = place.parent_path() / utf8_path(random_name());
  if (!old || !rename_open(old.number(), system_path(aside), kRename, kNoFlags)) return false;
  if (!rename_open(file, system_path(place), kRename, kNoFlags)) {
    const int error = errno;
    rename_open(old.number(), system_path(place), kRename, kNoFlags);
    errno = error;
    return false;
  }
  set_vanishing(old.number(), true);
  return true;
}

}  // namespace

fs::path end_of_links(const fs::path& path) {
  const DWORD attributes = ::GetFileAttributesW(system_path(path).c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES || !(attributes & FILE_ATTRIBUTE_REPARSE_POINT))
    return path;
  const std::optional<fs::path> end = real_path(path);
  if (!end) refuse(path, "is a link that cannot be followed");
  return *end;
}

/// On Windows `place_` is the whole path, and `name_` only tells whether the file has yet to take
/// its place.
StagedFile::StagedFile(fs::path path, Temporary temporary) : path_(std::move(path)) {
  const fs::path target = end_of_links(path_);
  if (!target.has_filename()) fail(path_.empty() ? ENOENT : EISDIR);
  replaces_ = is_replaced(path_, target);
  const std::string name = random_name();
  const fs::path named = target.parent_path() / utf8_path(name);
  file_ = opened(named, GENERIC_READ | GENERIC_WRITE | DELETE | WRITE_DAC, CREATE_NEW);
  if (!file_) fail(errno);
  place_ = target;
  name_ = name;
  if (replaces_) keep_permissions(file_.number(), target);
  if (temporary == Temporary::Unnamed) set_vanishing(file_.number(), true);
}

StagedFile::~StagedFile() {
  if (!name_.empty() && file_) set_vanishing(file_.number(), true);
}

void StagedFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  while (!bytes.empty()) {
    OVERLAPPED at{};
    at.Offset = static_cast<DWORD>(offset);
    at.OffsetHigh = static_cast<DWORD>(offset >> 32);
    DWORD put = 0;
    const auto count = static_cast<DWORD>(std::min(bytes.size(), kMost));
    if (!::WriteFile(handle_of(file_.number()), bytes.data(), count, &put, &at)) {
      failed();
      fail(errno);
    }
    offset += put;
    bytes = bytes.subspan(put);
  }
}

void StagedFile::commit(Existing existing) {
  commit_all({this, 1}, existing);
}

void StagedFile::commit_all(std::span<StagedFile> files, Existing existing) {
  synchronise_all(files, false);
  std::size_t placed = 0;
  try {
    for (; placed < files.size(); ++placed) files[placed].take_place(existing);
  } catch (const WriteError&) {
    for (const StagedFile& file : files.first(placed)) file.leave_place(existing);
    throw;
  }
  synchronise_all(files, true);
}

void StagedFile::synchronise_all(std::span<StagedFile> files, bool names) {
  for (const StagedFile& file : files)
    if (!synchronise(file.file_.number())) names ? file.fail_in_place(errno) : file.fail(errno);
}

void StagedFile::leave_place(Existing existing) const {
  if (existing == Existing::Refuse || !replaces_) set_vanishing(file_.number(), true);
}

void StagedFile::take_place(Existing existing) {
  const int file = file_.number();
  const std::wstring place = system_path(place_);
  const bool vanished = set_vanishing(file, false);
  const bool replaces = existing == Existing::Replace;
  if (vanished &&
      (replaces ? rename_open(file, place, kRenameWithFlags, kReplaceOpenFile) ||
                      rename_open(file, place, kRename, kReplace) || push_aside(file, place_)
                : rename_open(file, place, kRename, kNoFlags))) {
    name_.clear();
    return;
  }
  const int error = errno;
  set_vanishing(file, true);
  if (replaces && error == EACCES && status_of(place_)) refuse(path_, "is open in another program");
  fail(error);
}

}  // namespace mocapress
