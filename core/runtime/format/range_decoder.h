// SPDX-License-Identifier: MIT
// Based on: G. N. N. Martin, "Range encoding", 1979; carry-free as in M. Mahoney, "Adaptive
// Weighing of Context Models for Lossless Data Compression", 2005.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mocapress::runtime {

/// The probability of a set bit in 65536ths: 1 ... 65535.
using Probability = std::uint32_t;
inline constexpr Probability kEvenOdds = 32768;

/// The largest code that decodes to a one; larger codes decode to a zero.
constexpr std::uint32_t range_split(std::uint32_t low, std::uint32_t high, Probability one) {
  return low + static_cast<std::uint32_t>((static_cast<std::uint64_t>(high - low) * one) >> 16);
}

constexpr bool leading_byte_is_settled(std::uint32_t low, std::uint32_t high) {
  return ((low ^ high) >> 24) == 0;
}

/// Decodes bits that a range coder wrote. Any bytes decode to something. Decoding fails, for good,
/// once it has returned more bits than an encoder could have stored; this bounds the work by the
/// number of bytes.
class RangeDecoder {
 public:
  static constexpr bool kWrites = false;

  RangeDecoder(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {
    for (int i = 0; i < kRegister; ++i) shift_in();
  }

  /// Returns the next bit; ignores its first argument, which the encoder uses. Returns false after
  /// a failure.
  bool code(bool, Probability one) {
    if (failed()) return false;
    const std::uint32_t middle = range_split(low_, high_, one);
    const bool bit = code_ <= middle;
    if (bit)
      high_ = middle;
    else
      low_ = middle + 1;
    while (leading_byte_is_settled(low_, high_)) {
      low_ <<= 8;
      high_ = (high_ << 8) | 0xFF;
      shift_in();
    }
    return bit;
  }

  /// Makes decoding fail, because a decoded number is out of bounds.
  void refuse() { refused_ = true; }

  bool refused() const { return refused_; }
  bool exhausted() const { return next_ > size_ + kRegister; }
  bool failed() const { return refused_ || exhausted(); }

  /// True if all bytes were read, as is the case after the last coded bit.
  bool is_at_end() const { return next_ >= size_; }

  /// Bytes read so far.
  std::size_t position() const { return next_ < size_ ? next_ : size_; }

 private:
  static constexpr int kRegister = 4;  // bytes of low, high and code

  void shift_in() {
    code_ = code_ << 8 | (next_ < size_ ? bytes_[next_] : 0U);
    ++next_;
  }

  const std::uint8_t* bytes_;
  std::size_t size_;
  std::size_t next_ = 0;  // exceeds the size once zeros were read past the end
  std::uint32_t low_ = 0;
  std::uint32_t high_ = 0xFFFFFFFF;
  std::uint32_t code_ = 0;
  bool refused_ = false;
};

}  // namespace mocapress::runtime
