// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/number_text.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

namespace mocapress {
namespace {

TEST(LengthText, IsInMillimetresBelowACentimetre) {
  EXPECT_EQ(surplusText(0.04), QStringLiteral("+0.4 mm"));
  EXPECT_EQ(surplusText(0), QStringLiteral("0 mm"));
  EXPECT_EQ(lengthText(0.04), QStringLiteral("0.4 mm"));
  EXPECT_EQ(lengthText(0.456), QStringLiteral("4.6 mm"));
  EXPECT_EQ(lengthText(0.5), QStringLiteral("5.0 mm"));
  EXPECT_EQ(lengthText(0.994), QStringLiteral("9.9 mm"));
  EXPECT_EQ(lengthText(0.996), QStringLiteral("1.00 cm"));
  EXPECT_EQ(lengthText(1.234), QStringLiteral("1.23 cm"));
  EXPECT_EQ(lengthText(12.34), QStringLiteral("12.3 cm"));
  EXPECT_EQ(lengthText(486.7), QStringLiteral("487 cm"));
}

TEST(LengthText, NeverShowsANonzeroErrorAsZero) {
  EXPECT_EQ(lengthText(0), QStringLiteral("0 mm"));
  EXPECT_EQ(lengthText(0.004), QStringLiteral("0.04 mm"));
  EXPECT_EQ(lengthText(1e-9), QStringLiteral("< 0.01 mm"));
  for (double cm = 1e-7; cm < 1e4; cm *= 1.07)
    EXPECT_TRUE(lengthText(cm).contains(QRegularExpression(QStringLiteral("[1-9]")))) << cm;
}

TEST(LengthText, ScalesHaveNoDecimals) {
  EXPECT_EQ(roundLengthText(0.1), QStringLiteral("1 mm"));
  EXPECT_EQ(roundLengthText(0.25), QStringLiteral("2.5 mm"));
  EXPECT_EQ(roundLengthText(0.5), QStringLiteral("5 mm"));
  EXPECT_EQ(roundLengthText(1), QStringLiteral("1 cm"));
  EXPECT_EQ(roundLengthText(5), QStringLiteral("5 cm"));
}

TEST(RatioText, HasNoMoreThanThreeDigits) {
  EXPECT_EQ(ratioText(8), QStringLiteral("8.00 : 1"));
  EXPECT_EQ(ratioText(29.66), QStringLiteral("29.7 : 1"));
  EXPECT_EQ(ratioText(176.1), QStringLiteral("176 : 1"));
  EXPECT_EQ(ratioText(99.96), QStringLiteral("100 : 1"));
}

TEST(SizeText, HasNoMoreThanThreeDigits) {
  EXPECT_EQ(sizeText(812), QStringLiteral("812 bytes"));
  EXPECT_EQ(sizeText(1042), QStringLiteral("1.04 kB"));
  EXPECT_EQ(sizeText(10'420), QStringLiteral("10.4 kB"));
  EXPECT_EQ(sizeText(104'200), QStringLiteral("104 kB"));
  EXPECT_EQ(sizeText(2.5e6), QStringLiteral("2.50 MB"));
}

TEST(AngleText, HasNoMoreDigitsThanOneSees) {
  EXPECT_EQ(angleText(0.123), QStringLiteral("0.12°"));
  EXPECT_EQ(angleText(0.996), QStringLiteral("1.0°"));
  EXPECT_EQ(angleText(2.345), QStringLiteral("2.3°"));
  EXPECT_EQ(angleText(12.34), QStringLiteral("12.3°"));
  EXPECT_EQ(angleText(123.4), QStringLiteral("123°"));
}

TEST(AngleText, NeverShowsANonzeroAngleAsZero) {
  EXPECT_EQ(angleText(0), QStringLiteral("0°"));
  EXPECT_EQ(angleText(1e-9), QStringLiteral("< 0.01°"));
  for (double degrees = 1e-7; degrees < 180; degrees *= 1.07)
    EXPECT_TRUE(angleText(degrees).contains(QRegularExpression(QStringLiteral("[1-9]"))))
        << degrees;
}

TEST(AngleText, ScalesAreRound) {
  EXPECT_EQ(roundAngleText(1), QStringLiteral("1°"));
  EXPECT_EQ(roundAngleText(2.5), QStringLiteral("2.5°"));
  EXPECT_EQ(roundAngleText(15), QStringLiteral("15°"));
}

}  // namespace
}  // namespace mocapress
