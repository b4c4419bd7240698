// SPDX-License-Identifier: MIT
#include "core/codec/format/varint.h"

#include <gtest/gtest.h>

#include <bit>

#include "core/runtime/format/cursor.h"

namespace mocapress::varint_test {
namespace {

runtime::Cursor cursor_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

TEST(Varint, EveryLengthIsReadBack) {
  for (int bits = 0; bits < 63; ++bits)
    for (const std::uint64_t value : {(std::uint64_t{1} << bits) - 1, std::uint64_t{1} << bits}) {
      std::vector<std::byte> bytes;
      write_varint(bytes, value);
      EXPECT_EQ(bytes.size(), value == 0 ? 1 : (std::bit_width(value) + 6) / 7) << value;
      runtime::Cursor cursor = cursor_of(bytes);
      EXPECT_EQ(cursor.read_varint(), value);
      EXPECT_TRUE(cursor.at_end() && !cursor.failed()) << value;
    }
}

TEST(Varint, OneWithoutAnEndFails) {
  std::vector<std::byte> bytes;
  write_varint(bytes, 1000);
  bytes.pop_back();
  for (const std::vector<std::byte>& wrong :
       {bytes, std::vector<std::byte>(), std::vector<std::byte>(20, std::byte{0xFF})}) {
    runtime::Cursor cursor = cursor_of(wrong);
    cursor.read_varint();
    EXPECT_TRUE(cursor.failed()) << wrong.size();
  }
}

}  // namespace
}  // namespace mocapress::varint_test
