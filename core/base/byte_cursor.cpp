// SPDX-License-Identifier: MIT
#include "core/base/byte_cursor.h"

#include <algorithm>

#include "core/base/error.h"

namespace mocapress {

std::span<const std::byte> ByteReader::take(std::size_t size) {
  if (size > remaining())
    fail("ends here: " + std::to_string(size) + " bytes wanted, " + std::to_string(remaining()) +
         " left");
  const auto taken = bytes_.subspan(position_, size);
  position_ += size;
  return taken;
}

std::string ByteReader::read_short_string() {
  const auto characters = take(read<std::uint8_t>());
  return {reinterpret_cast<const char*>(characters.data()), characters.size()};
}

void ByteReader::fail(const std::string& message) const {
  throw FormatError(offset(), message);
}

void ByteReader::expect_end() const {
  if (remaining() > 0) fail(std::to_string(remaining()) + " bytes too many");
}

void ByteWriter::append(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void ByteWriter::write_short_string(const std::string& text) {
  const std::size_t length = std::min<std::size_t>(text.size(), 255);
  write(static_cast<std::uint8_t>(length));
  append(std::as_bytes(std::span(text)).first(length));
}

}  // namespace mocapress
