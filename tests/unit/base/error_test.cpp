// SPDX-License-Identifier: MIT
#include "core/base/error.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Error, InputErrorNamesFileLineAndColumn) {
  EXPECT_STREQ(InputError("a.bvh", 3, 7, "no number").what(), "a.bvh:3:7: no number");
}

TEST(Error, InputErrorOfAWholeFileNamesNoLine) {
  EXPECT_STREQ(InputError("a.bvh", 0, 0, "not found").what(), "a.bvh: not found");
}

TEST(Error, WarningNamesItsLine) {
  EXPECT_EQ((Warning{"a.bvh", 12, "one row too many"}.text()), "a.bvh:12: one row too many");
}

TEST(Error, MessageIsOneLineOfAtMost200Characters) {
  const auto message = [](const std::string& text) {
    return std::string(InputError("f", 0, 0, text).what()).substr(3);
  };
  EXPECT_STREQ(InputError("a\x1B[2J.bvh", 0, 0, "b").what(), "a\\x1b[2J.bvh: b");
  EXPECT_EQ(message("tab\there\x1B[2Jand \x7F \xC2\x9B there\n"),
            "tab\\x09here\\x1b[2Jand \\x7f \\x9b there\\x0a");
  EXPECT_EQ(message(std::string(200, 'x')), std::string(200, 'x'));
  EXPECT_EQ(message(std::string(201, 'x')), std::string(197, 'x') + "...");
  std::string umlauts;
  for (int i = 0; i < 30'000; ++i) umlauts += "\xC3\xBC";
  EXPECT_EQ(message(umlauts), umlauts.substr(0, 2 * 197) + "...");
  EXPECT_EQ((Warning{"f", 0, std::string(300, 'x')}.text()).size(), 203u);
}

}  // namespace
}  // namespace mocapress
