// SPDX-License-Identifier: MIT
#include "core/codec/format/section_writer.h"

#include "core/codec/format/section.h"

namespace mocapress {

void write_head(ByteWriter& file, std::uint16_t sections) {
  file.append(std::as_bytes(std::span(runtime::kMagic)));
  file.write(runtime::kVersion);
  file.write(sections);
}

void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload) {
  const auto size = static_cast<std::uint32_t>(payload.size());
  std::uint8_t head[8] = {};
  std::memcpy(head, tag.data(), 4);
  std::memcpy(head + 4, &size, 4);
  file.append(std::as_bytes(std::span(head)));
  file.write(runtime::section_checksum(head, reinterpret_cast<const std::uint8_t*>(payload.data()),
                                       payload.size()));
  file.append(payload);
}

}  // namespace mocapress
