// SPDX-License-Identifier: MIT
// The Windows calls behind the functions of open_file.h. File numbers are those of the C library,
// errors its errno values.
#pragma once

#ifndef NOMINMAX  // libstdc++ has it
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <filesystem>
#include <string>

#include "core/base/staged_file.h"

namespace mocapress::windows {

/// Sets errno by what GetLastError() tells, and returns false.
bool failed();

/// The handle behind a file number.
HANDLE handle_of(int file);

/// A path as the system's functions take it, absolute, and with the prefix that lifts their limit
/// of 260 characters if it is that long.
std::wstring system_path(const std::filesystem::path& path);

/// Opens or creates a file that others may read, write, rename and remove meanwhile, as on POSIX.
/// Nothing opened: errno.
FileDescriptor opened(const std::filesystem::path& path, DWORD access, DWORD creation,
                      DWORD flags = FILE_ATTRIBUTE_NORMAL);

}  // namespace mocapress::windows
