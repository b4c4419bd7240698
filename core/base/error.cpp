// SPDX-License-Identifier: MIT
#include "core/base/error.h"

#include <string_view>

#include "core/base/printable.h"

namespace mocapress {
namespace {

/// Returns the message as one line of at most 200 characters, however long the names in it are.
std::string one_line(const std::string& message) {
  constexpr std::size_t kLongest = 200;
  constexpr std::string_view kCut = "...";
  std::string line = printable(message);
  std::size_t characters = 0;
  std::size_t cut = 0;  // end of the longest beginning that leaves room for kCut
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool follows = (static_cast<unsigned char>(line[i]) & 0xC0U) == 0x80U;  // UTF-8
    if (!follows && ++characters == kLongest - kCut.size() + 1) cut = i;
    if (characters > kLongest) return line.substr(0, cut).append(kCut);
  }
  return line;
}

std::string at(const std::string& file, int line, int column, const std::string& message) {
  std::string place = printable(file);
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
