// SPDX-License-Identifier: MIT
// Changes the sections of a .mcpr file for tests, with corrected checksums, so that readers reach
// the changed bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace mocapress::test {

/// CRC-32 as in zlib, computed bit by bit, independently of both readers.
inline std::uint32_t plain_crc32(std::uint32_t crc, const std::byte* bytes, std::size_t size) {
  crc = ~crc;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= static_cast<std::uint32_t>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xEDB88320U : 0);
  }
  return ~crc;
}

/// Corrects the checksums of all complete sections.
inline void mend_checksums(std::vector<std::byte>& file) {
  std::size_t at = 8;
  while (at + 12 <= file.size()) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at + 4, 4);
    if (size > file.size() - at - 12) return;
    const std::uint32_t crc =
        plain_crc32(plain_crc32(0, file.data() + at, 8), file.data() + at + 12, size);
    std::memcpy(file.data() + at + 8, &crc, 4);
    at += 12 + size;
  }
}

}  // namespace mocapress::test
