// SPDX-License-Identifier: MIT
#include "core/runtime/format/section.h"

#include <array>

namespace mocapress::runtime {
namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int bit = 0; bit < 8; ++bit)
      table[i] = table[i] >> 1 ^ ((table[i] & 1) != 0 ? 0xEDB88320U : 0);
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

/// Updates a running CRC with more bytes. The caller inverts the final result.
std::uint32_t crc_of(std::uint32_t crc, const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) crc = crc >> 8 ^ kCrcTable[(crc ^ bytes[i]) & 0xFF];
  return crc;
}

}  // namespace

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size) {
  return ~crc_of(~0U, bytes, size);
}

std::uint32_t section_checksum(const std::uint8_t (&tag_and_size)[8], const std::uint8_t* payload,
                               std::size_t size) {
  return ~crc_of(crc_of(~0U, tag_and_size, sizeof tag_and_size), payload, size);
}

mcpr_result read_head(Cursor& file, std::uint16_t& sections) {
  const std::uint8_t* const magic = file.take(sizeof kMagic);
  if (magic == nullptr || std::memcmp(magic, kMagic, sizeof kMagic) != 0)
    return failure(MCPR_NOT_A_CLIP, 0, "not a Mocapress file");
  const auto version = file.read<std::uint16_t>();
  sections = file.read<std::uint16_t>();
  if (file.failed()) return failure(MCPR_DAMAGED, 4, "the file ends within its header");
  if (version != kVersion)
    return failure(MCPR_UNKNOWN_VERSION, 4, "the version is unknown: a newer Mocapress is needed");
  return kOk;
}

mcpr_result read_section(Cursor& file, Section& section) {
  section.start = file.offset();
  std::uint8_t head[8] = {};
  if (const std::uint8_t* const bytes = file.take(sizeof head))
    std::memcpy(head, bytes, sizeof head);
  const auto checksum = file.read<std::uint32_t>();
  std::uint32_t size = 0;
  std::memcpy(section.tag, head, 4);
  std::memcpy(&size, head + 4, 4);
  section.payload = {nullptr, size, file.offset()};
  section.payload.data = file.take(size);
  if (file.failed()) return failure(MCPR_DAMAGED, section.start, "the file ends within a section");
  if (section_checksum(head, section.payload.data, size) != checksum)
    return failure(MCPR_DAMAGED, section.start, "a section is damaged: its checksum differs");
  return kOk;
}

}  // namespace mocapress::runtime
