// SPDX-License-Identifier: MIT
#include "resources/samples/generator/curves.h"

#include <gtest/gtest.h>

namespace mocapress::samples {
namespace {

TEST(Curves, BallisticTrackIsTheFlightBetweenItsKnots) {
  const Eigen::Vector3d start(1, 2, 3);
  const Eigen::Vector3d velocity(10, 250, -40);
  const Eigen::Vector3d fall(0, -981, 0);
  const auto flight = [&](double t) -> Eigen::Vector3d {
    return start + velocity * t + fall * t * t / 2;
  };
  const BallisticTrack track(
      {{0, start, velocity, fall}, {0.5, flight(0.5), velocity + 0.5 * fall, fall}});
  for (double t = 0; t < 0.5; t += 0.03) EXPECT_LT((track.at(t) - flight(t)).norm(), 1e-10);
}

TEST(Curves, SplineReproducesACubic) {
  const auto cubic = [](double t) { return 1 + t * (2 + t * (-3 + t)); };
  const std::vector<double> seconds = {0, 0.4, 1.1, 2};
  Eigen::MatrixXd values(4, 1);
  for (Eigen::Index i = 0; i < 4; ++i) values(i, 0) = cubic(seconds[static_cast<std::size_t>(i)]);
  const Eigen::RowVectorXd first = Eigen::RowVectorXd::Constant(1, 2);
  const Eigen::RowVectorXd last = Eigen::RowVectorXd::Constant(1, 2);  // 2 - 6 t + 3 t^2 at 2
  const ClampedSpline spline(seconds, values, first, last);
  for (double t = 0; t <= 2; t += 0.1) EXPECT_NEAR(spline.at(t)(0), cubic(t), 1e-12);
}

TEST(Curves, KeyTrackRestsAtItsKeysAndBeyondThem) {
  const KeyTrack track({{0, 1}, {1, 5}, {2, -3}});
  EXPECT_EQ(track.at(-1), 1);
  EXPECT_EQ(track.at(3), -3);
  EXPECT_NEAR(track.at(1), 5, 1e-12);
  EXPECT_NEAR(track.at(0.5), 3, 1e-12);
  EXPECT_NEAR(track.at(1.001), 5, 1e-6);
}

}  // namespace
}  // namespace mocapress::samples
