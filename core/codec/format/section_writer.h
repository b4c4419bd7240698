// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "core/base/byte_cursor.h"

namespace mocapress {

/// Appends what a file begins with: as many sections follow.
void write_head(ByteWriter& file, std::uint16_t sections);

/// Appends a section: FORMAT.md. runtime::read_section() reads it.
void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload);

}  // namespace mocapress
