// SPDX-License-Identifier: MIT
#include "core/codec/format/section.h"

#include <zlib.h>

#include "core/base/error.h"

namespace mocapress {
namespace {

std::uint32_t checksum(std::span<const std::byte> head, std::span<const std::byte> payload) {
  const auto update = [](uLong crc, std::span<const std::byte> bytes) {
    if (bytes.empty()) return crc;  // zlib would begin anew where there is no memory at all
    return crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()),
                 static_cast<uInt>(bytes.size()));
  };
  return static_cast<std::uint32_t>(update(update(0, head), payload));
}

}  // namespace

Section read_section(ByteReader& file) {
  const std::size_t start = file.offset();
  const auto tag = file.take(4);
  const auto size = file.read<std::uint32_t>();
  const auto crc = file.read<std::uint32_t>();
  const std::size_t payload_offset = file.offset();
  const auto payload = file.take(size);
  Section section{{reinterpret_cast<const char*>(tag.data()), tag.size()}, payload, payload_offset};
  ByteWriter head;
  head.append(tag);
  head.write(size);
  if (checksum(head.bytes(), payload) != crc)
    throw FormatError(start, "section " + section.tag + " is damaged: its checksum differs");
  return section;
}

void write_section(ByteWriter& file, std::string_view tag, std::span<const std::byte> payload) {
  ByteWriter head;
  head.append(std::as_bytes(std::span(tag)));
  head.write(static_cast<std::uint32_t>(payload.size()));
  file.append(head.bytes());
  file.write(checksum(head.bytes(), payload));
  file.append(payload);
}

}  // namespace mocapress
