// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace mocapress {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

/// Reads little-endian values from untrusted bytes. Checks every read: a read past the end throws
/// FormatError. Offsets in errors count from `base_offset`, the place of these bytes in their file.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes, std::size_t base_offset = 0)
      : bytes_(bytes), base_offset_(base_offset) {}

  template <typename T>
  requires std::is_arithmetic_v<T> T read() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }

  /// Reads `size` bytes. The span points to them; nothing is copied.
  std::span<const std::byte> take(std::size_t size);

  /// Reads a string stored as one length byte and its characters.
  std::string read_short_string();

  std::size_t remaining() const { return bytes_.size() - position_; }
  std::size_t offset() const { return base_offset_ + position_; }

  /// Throws FormatError at the current offset.
  [[noreturn]] void fail(const std::string& message) const;

  /// Throws FormatError unless every byte was read.
  void expect_end() const;

 private:
  std::span<const std::byte> bytes_;
  std::size_t base_offset_;
  std::size_t position_ = 0;
};

/// Appends little-endian values.
class ByteWriter {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T>
  void write(T value) { append(std::as_bytes(std::span(&value, 1))); }
  void append(std::span<const std::byte> bytes);

  /// Writes a length byte and the characters. Cuts the text to 255 bytes.
  void write_short_string(const std::string& text);

  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::vector<std::byte> release() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace mocapress
