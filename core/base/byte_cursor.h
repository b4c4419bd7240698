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

/// Reads little-endian values from untrusted bytes. Every read is checked: one past the end throws
/// FormatError with the offset counted from `base_offset`, the place of these bytes in their file.
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

  /// The next `size` bytes, not copied.
  std::span<const std::byte> take(std::size_t size);

  /// A string stored as one length byte and its characters.
  std::string read_short_string();

  std::size_t remaining() const { return bytes_.size() - position_; }
  std::size_t offset() const { return base_offset_ + position_; }

  /// Throws FormatError at the present offset.
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

  /// At most 255 bytes are kept, as a length byte and the characters.
  void write_short_string(const std::string& text);

  const std::vector<std::byte>& bytes() const { return bytes_; }
  std::vector<std::byte> release() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace mocapress
