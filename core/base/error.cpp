// SPDX-License-Identifier: MIT
#include "core/base/error.h"

#include <string_view>

namespace mocapress {
namespace {

/// One line of at most 200 characters, whatever names and words of a file are in it.
std::string one_line(const std::string& message) {
  constexpr std::size_t kLongest = 200;
  constexpr std::string_view kCut = "...";
  std::string line;
  std::size_t characters = 0;
  std::size_t cut = 0;  // where the characters end that leave room for kCut
  for (std::size_t i = 0; i < message.size(); ++i) {
    const auto byte = static_cast<unsigned char>(message[i]);
    const bool follows = (byte & 0xC0U) == 0x80U;  // in UTF-8
    if (!follows && ++characters == kLongest - kCut.size() + 1) cut = line.size();
    if (characters > kLongest) return line.substr(0, cut).append(kCut);
    // U+0080 to U+009F are control characters as well, which some terminals obey.
    const bool is_control = byte < 0x20 || byte == 0x7F ||
                            (follows && byte < 0xA0 && !line.empty() && line.back() == '\xC2');
    if (is_control && follows)
      line.back() = ' ';
    else
      line += is_control ? ' ' : message[i];
  }
  return line;
}

std::string at(const std::string& file, int line, int column, const std::string& message) {
  std::string place = file;
  if (line > 0) place += ":" + std::to_string(line);
  if (line > 0 && column > 0) place += ":" + std::to_string(column);
  return place + ": " + one_line(message);
}

}  // namespace

InputError::InputError(const std::string& file, int line, int column, const std::string& message)
    : Error(at(file, line, column, message)), line_(line), column_(column) {}

FormatError::FormatError(std::size_t byte_offset, const std::string& message)
    : Error("byte " + std::to_string(byte_offset) + ": " + message), byte_offset_(byte_offset) {}

std::string Warning::text() const {
  return at(file, line, 0, message);
}

}  // namespace mocapress
