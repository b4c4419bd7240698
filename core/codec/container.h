// SPDX-License-Identifier: MIT
// The .mcpr file. Layout and what is rejected: FORMAT.md.
#pragma once

#include <filesystem>
#include <span>

#include "core/codec/compressed_clip.h"

namespace mocapress {

std::vector<std::byte> write_container(const CompressedClip& clip);

/// Throws FormatError on anything but a whole, intact file of a known version.
CompressedClip read_container(std::span<const std::byte> bytes);

/// The same from and to a file. Loading throws InputError, which names file and byte offset; saving
/// throws WriteError.
CompressedClip load_mcpr(const std::filesystem::path& path);
void save_mcpr(const std::filesystem::path& path, const CompressedClip& clip);

}  // namespace mocapress
