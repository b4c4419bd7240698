// SPDX-License-Identifier: MIT
#include "core/base/printable.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(Printable, ShowsControlCharactersInsteadOfSendingThem) {
  EXPECT_EQ(printable("a\x1b[31mb\n\x7f"), "a\\x1b[31mb\\x0a\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\x9b");  // one that opens an escape sequence by itself
}

TEST(Printable, ShowsMarksThatTurnTheDirectionOfText) {
  EXPECT_EQ(printable("a\u202egpj.exe"), "a\\u202egpj.exe");
  EXPECT_EQ(printable("\u200f\u2066"), "\\u200f\\u2066");
}

TEST(Printable, LeavesNamesOfAllLanguagesAlone) {
  EXPECT_EQ(printable("Hüfte 腰 – …"), "Hüfte 腰 – …");
  EXPECT_EQ(printable("broken \xe2\x80"), "broken \xe2\x80");
}

TEST(Printable, ShortensNamesBetweenCharacters) {
  const std::string name(40, 'n');
  EXPECT_EQ(shortened(name), name);
  EXPECT_EQ(shortened(name + 'n'), std::string(37, 'n') + "...");
  EXPECT_EQ(shortened(std::string(36, 'n') + "\u8170\u8170"), std::string(36, 'n') + "...");
}

}  // namespace
}  // namespace mocapress
