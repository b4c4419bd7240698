// SPDX-License-Identifier: MIT
#include "core/formats/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace mocapress {
namespace {

TEST(ParseNumber, ReadsEveryWayMotionFilesWriteOne) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-.25"), -0.25);
  EXPECT_EQ(parse_number("3."), 3.0);
  EXPECT_EQ(parse_number("1e-5"), 1e-5);
  EXPECT_EQ(parse_number("-6.48352E-028"), -6.48352e-28);
  EXPECT_EQ(parse_number("1e-999"), 0.0);
}

TEST(ParseNumber, KnowsTheSpellingsOfNotANumber) {
  for (const char* text : {"nan", "-nan", "NaN", "-nan(ind)", "1.#QNAN", "-1.#IND", "+1.#INF00",
                           "inf", "-Infinity", "1e999", "-1e999"}) {
    const auto value = parse_number(text);
    ASSERT_TRUE(value) << text;
    EXPECT_FALSE(std::isfinite(*value)) << text;
  }
}

TEST(ParseNumber, RefusesWhatIsNone) {
  for (const char* text : {"", "-", "+", "+-1", "1e", "1,5", "0x10", "12abc", "deadbeef"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(TextCursor, CountsLinesAndColumnsFromOneWithEveryLineEnding) {
  TextCursor cursor("f", "a  bc\r\n\td\re\n\nf", "", '\0');
  const auto expect_at = [&](std::string_view text, int line, int column) {
    const Token token = cursor.take();
    EXPECT_EQ(token.text, text);
    EXPECT_EQ(token.line, line) << text;
    EXPECT_EQ(token.column, column) << text;
  };
  expect_at("a", 1, 1);
  expect_at("bc", 1, 4);
  expect_at("d", 2, 2);
  expect_at("e", 3, 1);
  expect_at("f", 5, 1);
  EXPECT_TRUE(cursor.at_end());
}

TEST(TextCursor, SplitsPunctuationAndHidesComments) {
  TextCursor cursor("f", "# all of it\nJOINT a{x # rest }\n}", "{}", '#');
  EXPECT_TRUE(cursor.skip("joint"));
  EXPECT_EQ(cursor.take().text, "a");
  EXPECT_EQ(cursor.take().text, "{");
  EXPECT_EQ(cursor.take().text, "x");
  EXPECT_EQ(cursor.peek().line, 3);
  EXPECT_EQ(cursor.take().text, "}");
  EXPECT_TRUE(cursor.at_end());
}

TEST(TextCursor, TakesTheRestOfALineUpToAStop) {
  TextCursor cursor("f", "left  arm \t{ 1\nnext", "{}", '\0');
  EXPECT_EQ(cursor.take_line('{').text, "left  arm");
  EXPECT_EQ(cursor.take().text, "{");
  EXPECT_EQ(cursor.take_line().text, "1");
  EXPECT_EQ(cursor.take().text, "next");
}

TEST(TextCursor, SkipsAByteOrderMark) {
  TextCursor cursor("f", "\xEF\xBB\xBFHIERARCHY", "{}", '\0');
  EXPECT_TRUE(cursor.next_is("hierarchy"));
  EXPECT_EQ(cursor.peek().column, 1);
}

TEST(TextCursor, SaysWhereAndWhatStoodThere) {
  TextCursor cursor("walk.bvh", "OFFSET 1 zwei", "{}", '\0');
  cursor.expect("OFFSET");
  cursor.take_measure("a coordinate");
  try {
    cursor.take_measure("a coordinate");
    FAIL() << "a word was read as a number";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "walk.bvh:1:10: expected a coordinate, found 'zwei'");
  }
}

TEST(Quoted, KeepsMessagesShortAndPrintable) {
  const std::string noise(100, '\x01');
  EXPECT_EQ(quoted({noise, 1, 1}), "'" + std::string(40, '?') + "...'");
  EXPECT_EQ(quoted({}), "the end of the file");
}

}  // namespace
}  // namespace mocapress
