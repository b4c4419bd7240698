// SPDX-License-Identifier: MIT
#include "core/baselines/splines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/base/random.h"

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

Eigen::VectorXd chirp(int frames) {
  Eigen::VectorXd curve(frames);
  for (int t = 0; t < frames; ++t) curve(t) = 10 * std::sin(0.0004 * t * t);
  return curve;
}

TEST(KeyFrames, KeepTheSplineWithinTheTolerance) {
  const Eigen::VectorXd curve = chirp(600);
  std::size_t fewer = 0;
  for (const double tolerance : {5.0, 1.0, 0.1, 0.01}) {
    const std::vector<int> keys = choose_key_frames(curve, tolerance);
    EXPECT_LE((natural_spline(keys, curve(keys)) - curve).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_GT(keys.size(), fewer);
    fewer = keys.size();
  }
}

TEST(KeyFrames, StandWhereTheCurveMoves) {
  const std::vector<int> keys = choose_key_frames(chirp(600), 0.1);
  const auto early = std::count_if(keys.begin(), keys.end(), [](int key) { return key < 300; });
  EXPECT_GT(std::ssize(keys), 3 * early) << "the chirp is faster towards its end";
}

TEST(KeyFrames, RiseFromTheFirstFrameToTheLastWithoutLongGaps) {
  for (const int frames : {1, 2, 3, 256, 1000}) {
    const std::vector<int> keys = choose_key_frames(Eigen::VectorXd::Zero(frames), 1);
    EXPECT_EQ(keys.front(), 0);
    EXPECT_EQ(keys.back(), frames - 1);
    for (std::size_t i = 1; i < keys.size(); ++i) {
      EXPECT_GT(keys[i], keys[i - 1]);
      EXPECT_LE(keys[i] - keys[i - 1], kMostKeyGap);
    }
  }
}

TEST(KeyFrames, NoToleranceTakesEveryFrameOfNoise) {
  Eigen::VectorXd noise(40);
  for (int t = 0; t < 40; ++t) noise(t) = std::sin(1000.0 * t * t);
  EXPECT_EQ(choose_key_frames(noise, 0).size(), 40u);
}

TEST(Bezier, FitsCubicsExactly) {
  Eigen::MatrixXd rows(17, 2);
  for (int t = 0; t < 17; ++t) rows.row(t) << 1 + 0.5 * t - 0.1 * t * t, 0.01 * t * t * t - 2.0 * t;
  const Eigen::MatrixXd controls = fit_bezier(rows);
  EXPECT_LT((bezier_curve(rows.row(0), controls, 16) - rows.bottomRows(16)).norm(), 1e-6);
}

TEST(Bezier, KeepsUpToThreeFramesAfterTheStartExactly) {
  Random random(1);
  for (const int steps : {1, 2, 3}) {
    Eigen::MatrixXd rows(steps + 1, 4);
    for (double& value : rows.reshaped()) value = random.unit();
    const Eigen::MatrixXd controls = fit_bezier(rows);
    EXPECT_LT((bezier_curve(rows.row(0), controls, steps) - rows.bottomRows(steps)).norm(), 1e-6);
  }
}

TEST(Bezier, NoOtherInnerControlPointsComeNearer) {
  Random random(2);
  Eigen::MatrixXd rows(21, 1);
  for (double& value : rows.reshaped()) value = random.unit();
  const Eigen::MatrixXd controls = fit_bezier(rows);
  const auto error = [&](const Eigen::MatrixXd& of) {
    return (bezier_curve(rows.row(0), of, 20) - rows.bottomRows(20)).squaredNorm();
  };
  for (int point : {0, 1})
    for (const double change : {-1e-2, 1e-2}) {
      Eigen::MatrixXd other = controls;
      other(point, 0) += change;
      EXPECT_GT(error(other), error(controls));
    }
  EXPECT_EQ(controls(2, 0), rows(20, 0)) << "the end is kept";
}

}  // namespace
}  // namespace mocapress
