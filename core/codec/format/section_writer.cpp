// SPDX-License-Identifier: MIT
#include "core/codec/format/section_writer.h"

#include "core/codec/format/format_error.h"
#include "core/runtime/format/section.h"

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

std::vector<std::byte> with_section(std::span<const std::byte> mcpr, std::string_view tag,
                                    const std::optional<std::vector<std::byte>>& payload) {
  runtime::Cursor file(reinterpret_cast<const std::uint8_t*>(mcpr.data()), mcpr.size());
  std::uint16_t count = 0;
  require(runtime::read_head(file, count));
  std::uint16_t kept = 0;
  ByteWriter sections;
  for (int left = count; left > 0; --left) {
    runtime::Section section;
    require(runtime::read_section(file, section));
    if (section.is("TIER"))
      throw FormatError(section.start, "a file with tiers takes no further section");
    if (std::string_view(section.tag, 4) == tag) continue;
    sections.append(mcpr.subspan(section.start, file.offset() - section.start));
    ++kept;
  }
  if (!file.at_end()) throw FormatError(file.offset(), "bytes after the last section");
  if (payload) {
    write_section(sections, tag, *payload);
    ++kept;
  }
  ByteWriter whole;
  write_head(whole, kept);
  whole.append(sections.bytes());
  return whole.release();
}

}  // namespace mocapress
