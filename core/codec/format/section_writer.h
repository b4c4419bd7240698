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

/// Appends what a file begins with: as many sections follow.
void write_head(ByteWriter& file, std::uint16_t sections);

/// Appends a section: FORMAT.md. runtime::read_section() reads it.
void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload);

/// A whole file with an optional section at its end, in place of one it had; without a payload,
/// without the section. Throws FormatError.
std::vector<std::byte> with_section(std::span<const std::byte> mcpr, std::string_view tag,
                                    const std::optional<std::vector<std::byte>>& payload);

}  // namespace mocapress
