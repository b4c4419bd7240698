// SPDX-License-Identifier: MIT
// The Windows calls behind the functions of open_file.h. Files are given by the C library's file
// descriptors, and errors are its errno values.
#pragma once

#ifndef NOMINMAX  // libstdc++ may define it
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <filesystem>
#include <string>

#include "core/base/staged_file.h"

namespace mocapress::windows {

/// Sets errno according to GetLastError(), and returns false.
bool failed();

/// The Windows handle of a file descriptor.
HANDLE handle_of(int file);

/// An absolute path in the form that the system's functions take. Long paths get the prefix that
/// lifts the limit of 260 characters.
std::wstring system_path(const std::filesystem::path& path);

/// Opens or creates a file that others may still read, write, rename and remove, as on POSIX. The
/// result is empty on failure; errno tells why.
FileDescriptor opened(const std::filesystem::path& path, DWORD access, DWORD creation,
                      DWORD flags = FILE_ATTRIBUTE_NORMAL);

}  // namespace mocapress::windows
