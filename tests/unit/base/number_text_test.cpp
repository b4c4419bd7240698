// SPDX-License-Identifier: MIT
#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace mocapress {
namespace {

TEST(NumberText, FixedHasItsDecimals) {
  EXPECT_EQ(fixed_text(2.5, 2), "2.50");
  EXPECT_EQ(fixed_text(-0.125, 2), "-0.12");
  EXPECT_EQ(fixed_text(1234567.8, 0), "1234568");
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::max(), 1).size(), 311u);
}

TEST(NumberText, SignificantIsAsPrintfsG) {
  EXPECT_EQ(significant_text(120, 6), "120");
  EXPECT_EQ(significant_text(59.94, 6), "59.94");
  EXPECT_EQ(significant_text(0.000012345, 3), "1.23e-05");
  EXPECT_EQ(significant_text(1e6, 4), "1e+06");
}

TEST(NumberText, ShortestReadsBackAsTheSameNumber) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  for (const double value : {1.0 / 3, 1e-300, -2.5e17, 0.0, 5e-324})
    EXPECT_EQ(number_in(shortest_text(value)), value);
}

TEST(NumberText, ReadsAWholeTextOrNothing) {
  EXPECT_EQ(number_in("2.5"), 2.5);
  EXPECT_EQ(number_in("+2.5e1"), 25);
  for (const char* text : {"", "2,5", "2.5 cm", " 2.5", "+-1", "nan", "inf", "1e999", "0x10"})
    EXPECT_FALSE(number_in(text).has_value()) << text;
}

}  // namespace
}  // namespace mocapress
