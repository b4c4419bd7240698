// SPDX-License-Identifier: MIT
#include "core/report/json_value.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(CsvQuoted, QuotesWhatSeparates) {
  EXPECT_EQ(csv_quoted("walk"), "walk");
  EXPECT_EQ(csv_quoted("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_quoted("a \"b\""), "\"a \"\"b\"\"\"");
}

TEST(CsvQuoted, GivesASpreadsheetNoFormula) {
  EXPECT_EQ(csv_quoted("=HYPERLINK(A1)"), "'=HYPERLINK(A1)");
  EXPECT_EQ(csv_quoted("@SUM"), "'@SUM");
  EXPECT_EQ(csv_quoted("+1+2"), "'+1+2");
  EXPECT_EQ(csv_quoted("-walk.bvh"), "'-walk.bvh");
  EXPECT_EQ(csv_quoted("-1.5e-3"), "-1.5e-3");
}

TEST(CsvQuoted, ShowsControlCharacters) {
  EXPECT_EQ(csv_quoted("a\x1b[2Jb\tc"), "a\\x1b[2Jb\\x09c");
}

}  // namespace
}  // namespace mocapress
