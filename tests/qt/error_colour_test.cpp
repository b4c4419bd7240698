// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/error_colour.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

/// Relative luminance as WCAG defines it.
double luminance(const QColor& colour) {
  const auto linear = [](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(static_cast<double>(colour.redF())) +
         0.7152 * linear(static_cast<double>(colour.greenF())) +
         0.0722 * linear(static_cast<double>(colour.blueF()));
}

TEST(ErrorColour, GrowsLighterAllTheWaySoThatNoColourVisionIsNeeded) {
  double before = -1;
  for (int step = 0; step <= 200; ++step) {
    const double now = luminance(viridis(step / 200.0));
    EXPECT_GE(now, before) << step;
    before = now;
  }
  EXPECT_GT(luminance(viridis(1)), 30 * luminance(viridis(0)));
}

TEST(ErrorColour, BeginsAndEndsAsViridisDoes) {
  EXPECT_EQ(viridis(0), QColor(0x44, 0x01, 0x54));
  EXPECT_EQ(viridis(1), QColor(0xfd, 0xe7, 0x25));
  EXPECT_EQ(viridis(-1), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

TEST(ErrorScale, EndsAtARoundNumberNotBelowTheError) {
  for (const double cm : {0.013, 0.2, 0.49, 0.5, 0.51, 1.0, 1.7, 3.0, 7.3, 99.0, 200.0}) {
    const double top = errorScaleFor(cm).top;
    EXPECT_GE(top, cm * (1 - 1e-6));
    EXPECT_LE(top, 2.5 * cm);
    const double mantissa = top / std::pow(10.0, std::floor(std::log10(top) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                std::abs(mantissa - 5) < 1e-6)
        << top;
  }
}

TEST(ErrorScale, StaysWhereThereIsNoError) {
  EXPECT_EQ(errorScaleFor(0), ErrorScale());
  EXPECT_DOUBLE_EQ(ErrorScale{2}.share(1), 0.5);
  EXPECT_DOUBLE_EQ(ErrorScale{2}.share(3), 1);
}

}  // namespace
}  // namespace mocapress
