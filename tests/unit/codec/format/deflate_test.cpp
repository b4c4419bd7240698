// SPDX-License-Identifier: MIT
#include "core/codec/format/deflate.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace mocapress {
namespace {

std::vector<std::byte> pattern(std::size_t size) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * i / 7);
  return bytes;
}

TEST(Deflate, RestoresEverySize) {
  for (const std::size_t size : {0u, 1u, 4095u, 4096u, 4097u, 100000u})
    EXPECT_EQ(inflate_bytes(deflate_bytes(pattern(size)), size), pattern(size));
}

TEST(Deflate, RefusesToGrowBeyondTheLimit) {
  const auto bomb = deflate_bytes(std::vector<std::byte>(std::size_t{10} << 20));
  EXPECT_LT(bomb.size(), 20000u);
  EXPECT_THROW(inflate_bytes(bomb, 1000), FormatError);
}

TEST(Deflate, RefusesEveryPrefixAndBytesAfterTheEnd) {
  const auto packed = deflate_bytes(pattern(3000));
  for (std::size_t size = 0; size < packed.size(); ++size)
    EXPECT_THROW(inflate_bytes(std::span(packed).first(size), 3000), FormatError);
  auto longer = packed;
  longer.push_back(std::byte{0});
  EXPECT_THROW(inflate_bytes(longer, 3000), FormatError);
}

}  // namespace
}  // namespace mocapress
