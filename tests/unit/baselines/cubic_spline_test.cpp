// SPDX-License-Identifier: MIT
#include "core/baselines/cubic_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mocapress {
namespace {

TEST(NaturalSpline, PassesThroughItsKeysAndNothingElseDecidesIt) {
  const std::vector<int> frames = {3, 4, 9, 20, 21};
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(5, 1, 4).array().sin();
  const Eigen::VectorXd curve = natural_spline(frames, values);
  ASSERT_EQ(curve.size(), 19);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(curve(frames[static_cast<std::size_t>(i)] - 3), values(i), 1e-12);
}

TEST(NaturalSpline, IsExactForStraightLines) {
  const std::vector<int> frames = {0, 5, 7, 30};
  const Eigen::VectorXd curve = natural_spline(frames, Eigen::Vector4d(0, 10, 14, 60));
  for (int t = 0; t <= 30; ++t) EXPECT_NEAR(curve(t), 2 * t, 1e-12);
}

TEST(NaturalSpline, ErrsByTheFourthPowerOfTheGapInsideASmoothCurve) {
  const auto error = [](int gap) {
    std::vector<int> frames;
    for (int t = 0; t <= 960; t += gap) frames.push_back(t);
    Eigen::VectorXd values(std::ssize(frames));
    for (std::size_t i = 0; i < frames.size(); ++i)
      values(static_cast<Eigen::Index>(i)) = std::sin(0.02 * frames[i]);
    const Eigen::VectorXd curve = natural_spline(frames, values);
    double worst = 0;
    for (int t = 300; t <= 660; ++t)
      worst = std::max(worst, std::abs(curve(t) - std::sin(0.02 * t)));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(48) / error(24)), 4, 0.3);
}

TEST(NaturalSpline, OneKeyIsAPoint) {
  EXPECT_EQ(natural_spline(std::vector{7}, Eigen::VectorXd::Constant(1, 2.5)),
            Eigen::VectorXd::Constant(1, 2.5));
}

}  // namespace
}  // namespace mocapress
