// SPDX-License-Identifier: MIT
// The .mcpr file. Layout and what is rejected: FORMAT.md.
#pragma once

#include <filesystem>
#include <span>

#include "core/codec/format/compressed_clip.h"

namespace mocapress {

/// Throws Error where no file can hold the clip: check_room().
std::vector<std::byte> write_container(const CompressedClip& clip);

/// Throws FormatError on anything but a whole, intact file of a known version, whose motion is
/// wavelets.
CompressedClip read_container(std::span<const std::byte> bytes);

/// A clip whose motion is wavelets or, of a comparison method, the payload of a COMP section, which
/// core/baselines understands. Then basis, coding and provenance.method say nothing.
struct Container {
  CompressedClip clip;
  bool of_comparison = false;
};

std::vector<std::byte> write_container(const Container& container);
/// The sections of a file, checked against the format's limits. Throws FormatError.
runtime::FileSections sections_of(std::span<const std::byte> bytes);

Container read_any_container(std::span<const std::byte> bytes);

/// Wavelets from and to a file. Loading throws InputError, which names file and byte offset; saving
/// throws WriteError.
CompressedClip load_mcpr(const std::filesystem::path& path);
void save_mcpr(const std::filesystem::path& path, const CompressedClip& clip);

}  // namespace mocapress
