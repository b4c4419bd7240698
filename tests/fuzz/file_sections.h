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

/// Calls use(offset, bytes of the payload) for each complete section. Returns where they end.
template <typename Use>
std::size_t each_section(const std::vector<std::byte>& file, const Use& use) {
  std::uint16_t left = 0;
  if (file.size() >= 8) std::memcpy(&left, file.data() + 6, sizeof left);
  std::size_t at = 8;
  for (; left > 0 && at + 12 <= file.size(); --left) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + at + 4, sizeof size);
    if (size > file.size() - at - 12) break;
    use(at, size);
    at += 12 + size;
  }
  return at;
}

/// Corrects the checksums that TIER, if it is the first section, has of the pieces of finer tiers
/// behind the sections.
inline void mend_pieces(std::vector<std::byte>& file, std::size_t end_of_sections) {
  constexpr std::size_t kTiers = 20;
  if (end_of_sections <= kTiers || std::memcmp(file.data() + 8, "TIER", 4) != 0) return;
  const auto tiers = std::to_integer<unsigned>(file[kTiers]);
  std::size_t at = kTiers + 1;
  std::size_t piece = end_of_sections;
  for (unsigned t = 0; t < tiers; ++t) {
    std::uint64_t size = 0;
    for (unsigned shift = 0; shift < 64 && at < end_of_sections; shift += 7) {
      const auto byte = std::to_integer<std::uint64_t>(file[at++]);
      size |= (byte & 127) << shift;
      if (byte < 128) break;
    }
    if (t > 0) {
      if (at + 4 > end_of_sections || size > file.size() - piece) return;
      const std::uint32_t crc = plain_crc32(0, file.data() + piece, size);
      std::memcpy(file.data() + at, &crc, sizeof crc);
      at += sizeof crc;
      piece += size;
    }
    at += 5;
  }
}

/// Corrects the checksums of all complete sections and pieces.
inline void mend_checksums(std::vector<std::byte>& file) {
  mend_pieces(file, each_section(file, [](std::size_t, std::size_t) {}));
  each_section(file, [&file](std::size_t at, std::size_t size) {
    const std::uint32_t crc =
        plain_crc32(plain_crc32(0, file.data() + at, 8), file.data() + at + 12, size);
    std::memcpy(file.data() + at + 8, &crc, sizeof crc);
  });
}

}  // namespace mocapress::test
