// SPDX-License-Identifier: MIT
#include "core/runtime/format/trigonometry.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "core/base/random.h"

namespace mocapress::runtime::trigonometry_test {
namespace {

/// Units in the last place of `exact` between two numbers. Long doubles of x86 have 11 bits more.
double units_apart(double found, long double exact) {
  int exponent;
  std::frexp(static_cast<double>(exact), &exponent);
  return static_cast<double>(std::fabs(static_cast<long double>(found) - exact) /
                             std::ldexp(1.0L, exponent - std::numeric_limits<double>::digits));
}

TEST(Trigonometry, SinesAndCosinesAreWithinAUnitInTheLastPlace) {
  Random random(1);
  for (const double most : {0.7, 7.0, 700.0, 70000.0})
    for (int i = 0; i < 100000; ++i) {
      // As floats, since angles are decoded as floats: some lie close to quarter turns.
      const double angle = static_cast<float>(most * (2 * random.unit() - 1));
      const auto [sine, cosine] = sine_and_cosine(angle);
      ASSERT_LT(units_apart(sine, std::sin(static_cast<long double>(angle))), 1) << angle;
      ASSERT_LT(units_apart(cosine, std::cos(static_cast<long double>(angle))), 1) << angle;
    }
}

TEST(Trigonometry, SineOfASmallAngleIsTheAngle) {
  for (const double angle : {0.0, 1e-300, -1e-12}) EXPECT_EQ(sine_and_cosine(angle).sine, angle);
  EXPECT_EQ(sine_and_cosine(0).cosine, 1);
}

TEST(Trigonometry, HugeAnglesGiveSomePointOfTheCircle) {
  for (const double angle : {0x1p20, 1e7, -3e15, 1e300}) {
    const auto [sine, cosine] = sine_and_cosine(angle);
    EXPECT_NEAR(sine * sine + cosine * cosine, 1, 1e-15) << angle;
  }
  EXPECT_TRUE(std::isnan(sine_and_cosine(std::numeric_limits<double>::infinity()).sine));
}

TEST(Trigonometry, ArcTangentsAreWithinTwoUnitsInTheLastPlace) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const double y = 2 * random.unit() - 1;
    const double x = (2 * random.unit() - 1) * (i % 3 == 0 ? 1e-6 : 1);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    ASSERT_LT(units_apart(arc_tangent(y, x), exact), 2) << y << " " << x;
  }
}

TEST(Trigonometry, ArcTangentsOfTheAxesAndOfInfinitiesAreThoseOfTheLibrary) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double y : {0.0, -0.0, 1.0, -1.0, infinity, -infinity})
    for (const double x : {0.0, -0.0, 2.0, -2.0, infinity, -infinity})
      EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
  EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1)));
}

TEST(Trigonometry, ArcCosinesAreThoseOfTheLibrary) {
  for (int i = -1000; i <= 1000; ++i)
    EXPECT_NEAR(arc_cosine(i / 1000.0), std::acos(i / 1000.0), 1e-15) << i;
}

}  // namespace
}  // namespace mocapress::runtime::trigonometry_test
