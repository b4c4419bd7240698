// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/angle_text.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

namespace mocapress {
namespace {

TEST(AngleText, HasNoMoreDigitsThanOneSees) {
  EXPECT_EQ(angleText(0.123), QStringLiteral("0.12°"));
  EXPECT_EQ(angleText(0.996), QStringLiteral("1.0°"));
  EXPECT_EQ(angleText(2.345), QStringLiteral("2.3°"));
  EXPECT_EQ(angleText(12.34), QStringLiteral("12.3°"));
  EXPECT_EQ(angleText(123.4), QStringLiteral("123°"));
}

TEST(AngleText, ShowsNoTurnAsNothingThatIsNotNothing) {
  EXPECT_EQ(angleText(0), QStringLiteral("0°"));
  EXPECT_EQ(angleText(1e-9), QStringLiteral("< 0.01°"));
  for (double degrees = 1e-7; degrees < 180; degrees *= 1.07)
    EXPECT_TRUE(angleText(degrees).contains(QRegularExpression(QStringLiteral("[1-9]"))))
        << degrees;
}

TEST(AngleText, OfScalesIsRound) {
  EXPECT_EQ(roundAngleText(1), QStringLiteral("1°"));
  EXPECT_EQ(roundAngleText(2.5), QStringLiteral("2.5°"));
  EXPECT_EQ(roundAngleText(15), QStringLiteral("15°"));
}

}  // namespace
}  // namespace mocapress
