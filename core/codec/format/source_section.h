// SPDX-License-Identifier: MIT
// The section `srce` of a .mcpr file: FORMAT.md. The section says nothing about the motion, so that
// the reader and the writer of clips need not know it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "core/motion/source_format.h"

namespace mocapress {

/// Returns the file with the section at its end, which replaces an existing one. Leaves the section
/// out where `source` has no kind or a unit that FORMAT.md does not allow. Requires a whole file as
/// write_container() makes it.
std::vector<std::byte> with_source(std::span<const std::byte> mcpr, const SourceFormat& source);

/// Reads the section; the result has no kind if the file lacks the section. Throws FormatError.
SourceFormat source_of(std::span<const std::byte> mcpr);

/// Reads the section of the file at a path. Throws InputError.
SourceFormat load_source(const std::filesystem::path& mcpr);

}  // namespace mocapress
