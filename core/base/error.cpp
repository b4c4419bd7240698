// SPDX-License-Identifier: MIT
#include "core/base/error.h"

namespace mocapress {
namespace {

std::string at(const std::string& file, int line, int column, const std::string& message) {
  std::string place = file;
  if (line > 0) place += ":" + std::to_string(line);
  if (line > 0 && column > 0) place += ":" + std::to_string(column);
  return place + ": " + message;
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
