// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/constant_value.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(ConstantValue, IsWithinSixtyFourStepsOfTheValue) {
  for (const double step : {0x1p-9, 0x1.8p-7, 0x1.fep-12})
    for (double value = 0.01; value < 2000; value *= 1.37)
      for (const double either : {value, -value})
        EXPECT_NEAR(steps_of_constant(either, step) * step, either, 64 * step) << step;
}

TEST(ConstantValue, IsTheNearestWhereAllItsDigitsFit) {
  EXPECT_EQ(steps_of_constant(91.3, 0x1p-8), 23373);
  EXPECT_EQ(steps_of_constant(0, 0x1p-8), 0);
}

TEST(ConstantValue, IsAWholeNumberForAHugeValueToo) {
  EXPECT_GT(steps_of_constant(1e30, 1), 1 << 27);
  EXPECT_LT(steps_of_constant(-1e30, 1), -(1 << 27));
}

}  // namespace
}  // namespace mocapress
