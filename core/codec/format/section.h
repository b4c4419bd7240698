// SPDX-License-Identifier: MIT
// The sections that a .mcpr file is made of: FORMAT.md.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "core/base/byte_cursor.h"

namespace mocapress {

struct Section {
  std::string tag;
  std::span<const std::byte> payload;
  std::size_t payload_offset;
};

/// The next section. Throws FormatError when its checksum differs.
Section read_section(ByteReader& file);

void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload);

}  // namespace mocapress
