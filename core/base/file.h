// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/staged_file.h"

namespace mocapress {

/// Opens a file for reading. Throws InputError if that fails, and for pipes, sockets and devices,
/// without waiting for them.
FileDescriptor open_to_read(const std::filesystem::path& path);

/// Reads a whole file. Throws InputError if the file cannot be read, does not fit into the memory
/// limit, or is a pointer of Git LFS.
std::vector<std::byte> read_bytes(const std::filesystem::path& path);
std::string read_text(const std::filesystem::path& path);

/// Writes a file as StagedFile does: a reader sees the old file or the new one, and a failure
/// leaves the old one. Throws WriteError.
void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_text(const std::filesystem::path& path, std::string_view text);

/// Writes text that is too long to keep in memory, as StagedFile does: `write` writes it to a
/// stream, which ignores the locale.
void write_stream(const std::filesystem::path& path,
                  const std::function<void(std::ostream&)>& write);

}  // namespace mocapress
