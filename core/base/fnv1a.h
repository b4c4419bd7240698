// SPDX-License-Identifier: MIT
// FNV-1a, 64 bits, as in RFC 9923.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace mocapress {

/// A hash that tells whether bytes have changed. It does not protect against forgery.
class Fnv1a {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      state_ ^= std::to_integer<std::uint64_t>(byte);
      state_ *= 0x100000001b3u;
    }
  }
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }

  std::uint64_t state() const { return state_; }

  /// The hash as 16 hexadecimal digits.
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_));
    return digits;
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

}  // namespace mocapress
