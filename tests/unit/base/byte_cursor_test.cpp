// SPDX-License-Identifier: MIT
#include "core/base/byte_cursor.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace mocapress {
namespace {

TEST(ByteCursor, ReadsBackWhatWasWritten) {
  ByteWriter writer;
  writer.write(std::uint16_t{0x1234});
  writer.write(-1.5);
  writer.write_short_string("knee");
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.read<std::uint16_t>(), 0x1234);
  EXPECT_EQ(reader.read<double>(), -1.5);
  EXPECT_EQ(reader.read_short_string(), "knee");
  EXPECT_NO_THROW(reader.expect_end());
}

TEST(ByteCursor, IsLittleEndian) {
  ByteWriter writer;
  writer.write(std::uint32_t{0x01020304});
  EXPECT_EQ(writer.bytes().front(), std::byte{4});
}

TEST(ByteCursor, RefusesToReadPastTheEndAndNamesTheOffset) {
  const std::vector<std::byte> bytes(6);
  ByteReader reader(bytes, 100);
  reader.read<std::uint32_t>();
  try {
    reader.read<std::uint32_t>();
    FAIL() << "read past the end";
  } catch (const FormatError& error) {
    EXPECT_EQ(error.byte_offset(), 104u);
  }
}

TEST(ByteCursor, RefusesASizeThatWouldOverflow) {
  const std::vector<std::byte> bytes(6);
  ByteReader reader(bytes);
  reader.take(3);
  EXPECT_THROW(reader.take(SIZE_MAX), FormatError);
}

TEST(ByteCursor, CutsStringsAt255Bytes) {
  ByteWriter writer;
  writer.write_short_string(std::string(300, 'x'));
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.read_short_string().size(), 255u);
}

TEST(ByteCursor, RefusesBytesLeftOver) {
  const std::vector<std::byte> bytes(1);
  EXPECT_THROW(ByteReader(bytes).expect_end(), FormatError);
}

}  // namespace
}  // namespace mocapress
