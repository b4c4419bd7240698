// SPDX-License-Identifier: MIT
#include "core/codec/range_coder.h"

#include <cassert>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::size_t kRegister = 4;  // bytes of low, high and code

/// Where [low, high] is divided: ones below and at it, zeros above.
std::uint32_t split(std::uint32_t low, std::uint32_t high, Probability probability_of_one) {
  assert(probability_of_one > 0 && probability_of_one < 65536);
  return low + static_cast<std::uint32_t>(
                   (static_cast<std::uint64_t>(high - low) * probability_of_one) >> 16);
}

bool leading_byte_is_settled(std::uint32_t low, std::uint32_t high) {
  return ((low ^ high) >> 24) == 0;
}

}  // namespace

void RangeEncoder::code(bool bit, Probability probability_of_one) {
  const std::uint32_t middle = split(low_, high_, probability_of_one);
  if (bit)
    high_ = middle;
  else
    low_ = middle + 1;
  while (leading_byte_is_settled(low_, high_)) {
    bytes_.push_back(static_cast<std::byte>(high_ >> 24));
    low_ <<= 8;
    high_ = (high_ << 8) | 0xFF;
  }
}

std::vector<std::byte> RangeEncoder::finish() {
  // The shortest number in [low, high]; the decoder reads zeros after it.
  for (int shift = 24; low_ != 0; shift -= 8) {
    const std::uint32_t mask = (shift == 32 ? 0 : (std::uint32_t{1} << shift)) - 1;
    const std::uint32_t rounded = (low_ + mask) & ~mask;
    if (rounded < low_ || rounded > high_) continue;
    for (int at = 24; at >= shift; at -= 8)
      bytes_.push_back(static_cast<std::byte>(rounded >> at & 0xFF));
    break;
  }
  return std::move(bytes_);
}

RangeDecoder::RangeDecoder(std::span<const std::byte> bytes, std::size_t base_offset)
    : bytes_(bytes), base_offset_(base_offset) {
  for (std::size_t i = 0; i < kRegister; ++i) shift_in();
}

void RangeDecoder::shift_in() {
  if (next_ >= bytes_.size() + kRegister)
    throw FormatError(base_offset_ + bytes_.size(), "the coded bits end early");
  const std::uint32_t byte = next_ < bytes_.size() ? static_cast<std::uint32_t>(bytes_[next_]) : 0;
  code_ = code_ << 8 | byte;
  ++next_;
}

bool RangeDecoder::code(Probability probability_of_one) {
  const std::uint32_t middle = split(low_, high_, probability_of_one);
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

void RangeDecoder::expect_end() const {
  if (next_ < bytes_.size()) throw FormatError(base_offset_ + next_, "bytes after the coded bits");
}

}  // namespace mocapress
