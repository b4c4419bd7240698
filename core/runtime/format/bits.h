// SPDX-License-Identifier: MIT
// Bit streams of the resident form. The first bit is the least significant one of a byte. Numbers
// have a fixed width or are Rice coded (R. F. Rice, "Some practical universal noiseless coding
// techniques", 1979).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/processor/processor.h"

namespace mocapress::runtime {

inline constexpr int kRiceEscape = 16;  // after this many zeros, a number follows in plain binary
inline constexpr int kPlainBits = 32;   // bits of a number in plain binary
inline constexpr int kMostRiceShift = 24;
inline constexpr std::size_t kReadAhead = 32;  // bytes that a reader may touch after the last bit

/// Length in bits of the Rice code of `v`.
constexpr int rice_bits(std::uint32_t v, int shift) {
  const std::uint32_t quotient = v >> shift;
  return quotient < kRiceEscape ? static_cast<int>(quotient) + 1 + shift : kRiceEscape + kPlainBits;
}

/// Writes bits to zeroed memory. Without memory it only counts them.
class BitWriter {
 public:
  explicit BitWriter(std::byte* bytes) : bytes_(bytes) {}

  void put(std::uint64_t value, int width) {
    for (; width > 0 && bytes_ != nullptr; --width, value >>= 1, ++at_)
      bytes_[at_ >> 3] |= static_cast<std::byte>((value & 1) << (at_ & 7));
    at_ += static_cast<std::uint64_t>(width);
  }

  void put_rice(std::uint32_t v, int shift) {
    const std::uint32_t quotient = v >> shift;
    if (quotient >= kRiceEscape) {
      put(0, kRiceEscape);
      return put(v, kPlainBits);
    }
    put(std::uint64_t{1} << quotient, static_cast<int>(quotient) + 1);
    put(v & ((std::uint32_t{1} << shift) - 1), shift);
  }

  void align_to_byte() { at_ = (at_ + 7) / 8 * 8; }
  std::uint64_t bits() const { return at_; }

 private:
  std::byte* bytes_;
  std::uint64_t at_ = 0;
};

/// Returns the bits from position `bit` on, at least 57 of them.
inline std::uint64_t bits_at(const std::byte* bytes, std::uint64_t bit) {
  std::uint64_t word;
  std::memcpy(&word, bytes + (bit >> 3), sizeof word);
  return word >> (bit & 7);
}

/// Reads what a BitWriter wrote.
class BitReader {
 public:
  explicit BitReader(const std::byte* bytes) : bytes_(bytes) {}

  std::uint32_t rice(int shift) {
    const std::uint64_t word = bits_at(bytes_, at_);
    // A guard bit at position kRiceEscape limits the count, so that a word of zeros needs no
    // branch.
    const int quotient = std::countr_zero(word | std::uint64_t{1} << kRiceEscape);
    if (quotient == kRiceEscape) {
      at_ += kRiceEscape + kPlainBits;
      return static_cast<std::uint32_t>(word >> kRiceEscape);
    }
    at_ += static_cast<std::uint64_t>(quotient + 1 + shift);
    const auto rest = static_cast<std::uint32_t>(word >> (quotient + 1));
    return static_cast<std::uint32_t>(quotient) << shift |
           (rest & ((std::uint32_t{1} << shift) - 1));
  }

  bool flag() {
    const bool set = (bits_at(bytes_, at_) & 1) != 0;
    ++at_;
    return set;
  }

  std::uint64_t bits() const { return at_; }  // bits read so far

 private:
  const std::byte* bytes_;
  std::uint64_t at_ = 0;
};

}  // namespace mocapress::runtime
