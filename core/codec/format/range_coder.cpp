// SPDX-License-Identifier: MIT
#include "core/codec/format/range_coder.h"

#include <cassert>
#include <stdexcept>

namespace mocapress {

bool RangeEncoder::code(bool bit, Probability probability_of_one) {
  assert(probability_of_one > 0 && probability_of_one < 65536);
  const std::uint32_t middle = runtime::range_split(low_, high_, probability_of_one);
  if (bit)
    high_ = middle;
  else
    low_ = middle + 1;
  while (runtime::leading_byte_is_settled(low_, high_)) {
    bytes_.push_back(static_cast<std::byte>(high_ >> 24));
    low_ <<= 8;
    high_ = (high_ << 8) | 0xFF;
  }
  return bit;
}

std::vector<std::byte> RangeEncoder::finish() {
  // Writes the shortest number in [low, high]; the decoder reads zeros after it.
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

std::vector<std::byte> CheckedRangeEncoder::finish() {
  std::vector<std::byte> bytes = encoder_.finish();
  runtime::RangeDecoder decoder(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  bool all_come_back = true;
  for (const std::uint32_t coded : coded_)
    all_come_back &= decoder.code(false, coded >> 1) == ((coded & 1) != 0);
  if (!all_come_back || decoder.failed() || !decoder.is_at_end())
    throw std::logic_error("the range coder's bytes do not say what was coded");
  return bytes;
}

}  // namespace mocapress
