// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/processor/processor.h"

namespace mocapress::runtime {

/// Reads little-endian values from untrusted bytes. Reading past the end puts the cursor into a
/// failed state, which is permanent; values read then are zero.
class Cursor {
 public:
  Cursor(const std::uint8_t* bytes, std::size_t size, std::size_t base_offset = 0)
      : bytes_(bytes), size_(size), base_offset_(base_offset) {}

  template <typename T>
  T read() {
    T value{};
    if (const std::uint8_t* const from = take(sizeof(T))) std::memcpy(&value, from, sizeof(T));
    return value;
  }

  /// Reads groups of 7 bits, lowest first; the eighth bit says that another follows.
  std::uint64_t read_varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const auto byte = read<std::uint8_t>();
      value |= std::uint64_t{byte & 0x7FU} << shift;
      if (byte < 0x80) return value;
    }
    fail();
    return 0;
  }

  /// Returns the next `size` bytes in place; null if there are fewer.
  const std::uint8_t* take(std::size_t size) {
    if (failed_ || size > size_ - at_) {
      failed_ = true;
      return nullptr;
    }
    const std::uint8_t* const taken = bytes_ + at_;
    at_ += size;
    return taken;
  }

  void fail() { failed_ = true; }
  bool failed() const { return failed_; }
  bool at_end() const { return at_ == size_; }
  std::size_t left() const { return size_ - at_; }
  std::size_t offset() const { return base_offset_ + at_; }  // position in the file

 private:
  const std::uint8_t* bytes_;
  std::size_t size_;
  std::size_t base_offset_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace mocapress::runtime
