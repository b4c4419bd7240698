// SPDX-License-Identifier: MIT
// The sections of a .mcpr file: FORMAT.md. section_writer.h writes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/cursor.h"
#include "core/runtime/format/result.h"

namespace mocapress::runtime {

inline constexpr char kMagic[] = {'M', 'C', 'P', 'R'};
inline constexpr std::uint16_t kVersion = 1;
inline constexpr std::size_t kFileHead = 8;      // magic, version, number of sections
inline constexpr std::size_t kSectionHead = 12;  // tag, size, checksum

/// A range of bytes in a file.
struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
  std::size_t offset = 0;  // position in the file

  Cursor cursor() const { return {data, size, offset}; }
};

struct Section {
  char tag[4] = {};
  std::size_t start = 0;  // position in the file
  Bytes payload;

  bool is(const char* name) const { return std::memcmp(tag, name, 4) == 0; }
  bool is_optional() const { return tag[0] >= 'a' && tag[0] <= 'z'; }
};

/// CRC-32, as in zlib.
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size);

/// Checksum of a section: CRC-32 of its tag, size and payload.
std::uint32_t section_checksum(const std::uint8_t (&tag_and_size)[8], const std::uint8_t* payload,
                               std::size_t size);

/// Reads the head of the file; sets the number of sections.
mcpr_result read_head(Cursor& file, std::uint16_t& sections);

/// Reads the next section and verifies its checksum.
mcpr_result read_section(Cursor& file, Section& section);

}  // namespace mocapress::runtime
