// SPDX-License-Identifier: MIT
#include "core/base/base64.h"

#include <gtest/gtest.h>

#include <utility>

namespace mocapress::test {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  for (const auto& [bytes, text] :
       {std::pair("", ""), std::pair("f", "Zg=="), std::pair("fo", "Zm8="),
        std::pair("foo", "Zm9v"), std::pair("foob", "Zm9vYg=="), std::pair("foobar", "Zm9vYmFy")})
    EXPECT_EQ(base64_of(bytes), text);
  EXPECT_EQ(base64_of(std::string_view("\xff\0\xfe", 3)), "/wD+");
}

TEST(Base64, ComesBackWhateverStandsBetweenItsDigits) {
  for (const std::string bytes : {"", "f", "fo", "foo", "foob", "\xff\xfe\x01\x80"})
    EXPECT_EQ(bytes_of_base64(base64_of(bytes)), bytes);
  EXPECT_EQ(bytes_of_base64("Zm9v\n Ym\"Fy"), "foobar");
}

}  // namespace
}  // namespace mocapress::test
