// SPDX-License-Identifier: MIT
#include "core/base/printable.h"

#include <cstdio>

namespace mocapress {
namespace {

/// True for Unicode's marks that change the direction of text: U+200E, U+200F, U+202A to U+202E,
/// U+2066 to U+2069.
bool turns_direction(unsigned code) {
  return code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string line;
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(i < text.size() ? text[i] : 0));
  };
  const auto put = [&](const char* format, unsigned code) {
    char escaped[16];
    std::snprintf(escaped, sizeof escaped, format, code);
    line += escaped;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (byte(i) < 0x20 || byte(i) == 0x7f) {
      put("\\x%02x", byte(i));
      continue;
    }
    if (byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0) {  // U+0080 to U+009F
      put("\\x%02x", byte(++i));
      continue;
    }
    // The code point, if these are three bytes of UTF-8: the first byte holds its upper four bits.
    const unsigned code =
        (byte(i) & 0xfU) << 12 | (byte(i + 1) & 0x3fU) << 6 | (byte(i + 2) & 0x3fU);
    if (byte(i) == 0xe2 && turns_direction(code)) {
      put("\\u%04x", code);
      i += 2;
      continue;
    }
    line += text[i];
  }
  return line;
}

std::string shortened(const std::string& name) {
  constexpr std::size_t kLongest = 40;
  if (name.size() <= kLongest) return name;
  std::size_t end = kLongest - 3;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;  // UTF-8
  return name.substr(0, end) + "...";
}

}  // namespace mocapress
