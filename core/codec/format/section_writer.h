// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/byte_cursor.h"

namespace mocapress {

/// Appends the head of a file that is followed by `sections` sections.
void write_head(ByteWriter& file, std::uint16_t sections);

/// Appends a section (FORMAT.md), which runtime::read_section() reads.
void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload);

/// Returns the file with an optional section at its end, which replaces an existing one; without a
/// payload the section is removed. Throws FormatError.
std::vector<std::byte> with_section(std::span<const std::byte> mcpr, std::string_view tag,
                                    const std::optional<std::vector<std::byte>>& payload);

}  // namespace mocapress
