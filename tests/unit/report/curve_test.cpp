// SPDX-License-Identifier: MIT
#include "core/report/curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mocapress {
namespace {

TEST(Curve, KeepsOnlyPointsThatNoOtherBeats) {
  // 12:1 with 0.6 cm is beaten by 20:1 with 0.5 cm, the second 10:1 by the first.
  const Curve curve = best_of({{20, 0.5}, {10, 0.2}, {12, 0.6}, {10, 0.3}, {40, 1.5}});
  ASSERT_EQ(curve.size(), 3u);
  EXPECT_EQ(curve[0].ratio, 10);
  EXPECT_EQ(curve[0].eps_cm, 0.2);
  EXPECT_EQ(curve[1].ratio, 20);
  EXPECT_EQ(curve[2].ratio, 40);
}

TEST(Curve, LeavesOutWhatHasNoLogarithm) {
  EXPECT_TRUE(best_of({{5, 0}, {0, 1}, {-3, 2}, {4, std::nan("")}}).empty());
}

TEST(Curve, IsStraightInLogarithms) {
  // Twice the error for four times the ratio: eps = 0.1 sqrt(ratio / 10).
  const Curve curve = {{10, 0.1}, {40, 0.2}};
  EXPECT_NEAR(*ratio_at(curve, 0.1 * std::sqrt(2)), 20, 1e-12);
  EXPECT_EQ(*ratio_at(curve, 0.1), 10);
  EXPECT_NEAR(*ratio_at(curve, 0.2), 40, 1e-12);
}

TEST(Curve, IsNotExtrapolated) {
  const Curve curve = {{10, 0.1}, {40, 0.2}};
  EXPECT_FALSE(ratio_at(curve, 0.099));
  EXPECT_FALSE(ratio_at(curve, 0.201));
  EXPECT_FALSE(ratio_at({}, 0.1));
}

TEST(Curve, KeepsASinglePoint) {
  EXPECT_EQ(*ratio_at({{7, 0.3}}, 0.3), 7);
  EXPECT_FALSE(ratio_at({{7, 0.3}}, 0.31));
}

TEST(GeometricMean, TwoAndEightGiveFour) {
  EXPECT_NEAR(*geometric_mean(std::vector<double>{2, 8}), 4, 1e-12);
  EXPECT_FALSE(geometric_mean({}));
}

TEST(MeanCurve, IsTheGeometricMeanOfRatiosAtEqualError) {
  // At any error the second clip is four times as small: their mean is twice the first.
  const std::vector<Curve> curves = {{{10, 0.1}, {40, 0.4}}, {{40, 0.1}, {160, 0.4}}};
  const Curve mean = mean_at_equal_error(curves, 3);
  ASSERT_EQ(mean.size(), 3u);
  EXPECT_NEAR(mean[0].ratio, 20, 1e-9);
  EXPECT_NEAR(mean[1].eps_cm, 0.2, 1e-12);
  EXPECT_NEAR(mean[1].ratio, 40, 1e-9);
  EXPECT_NEAR(mean[2].ratio, 80, 1e-9);
}

TEST(MeanCurve, CoversOnlyTheErrorsOfEveryCurve) {
  const std::vector<Curve> curves = {{{10, 0.1}, {40, 0.4}}, {{5, 0.2}, {50, 2}}};
  const Curve mean = mean_at_equal_error(curves);
  EXPECT_NEAR(mean.front().eps_cm, 0.2, 1e-12);
  EXPECT_EQ(mean.back().eps_cm, 0.4);
  EXPECT_TRUE(
      mean_at_equal_error(std::vector<Curve>{{{10, 0.1}, {20, 0.2}}, {{5, 1}, {6, 2}}}).empty());
  EXPECT_TRUE(mean_at_equal_error(std::vector<Curve>{{{10, 0.1}, {20, 0.2}}, {}}).empty());
  EXPECT_TRUE(mean_at_equal_error({}).empty());
}

}  // namespace
}  // namespace mocapress
