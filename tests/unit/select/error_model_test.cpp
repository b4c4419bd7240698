// SPDX-License-Identifier: MIT
#include "core/select/error_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/metrics/distortion.h"
#include "tests/support/landmark_jacobian.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Eigen::MatrixXd brute_force_form(const Motion& motion, int frame, const MeasuredPoints& measured) {
  const auto& [points, weights] = measured;
  const Eigen::MatrixXd jacobian = test::point_jacobian(motion, points, frame);
  Eigen::VectorXd each_coordinate(3 * weights.size());
  for (int p = 0; p < weights.size(); ++p)
    each_coordinate.segment<3>(3 * p).setConstant(weights(p));
  return jacobian.transpose() * each_coordinate.asDiagonal() * jacobian;
}

class ErrorModelOf : public testing::TestWithParam<Weighting> {
 protected:
  const Motion motion_ = test::smooth_motion(150);
  const MeasuredPoints measured_ = measured_points(motion_.skeleton, GetParam());
  const ErrorModel model_{motion_.skeleton, motion_.clip, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Weightings, ErrorModelOf, testing::ValuesIn(kWeightingsWithoutMesh));

TEST_P(ErrorModelOf, CurvatureIsTheDiagonalOfTheBruteForceForm) {
  for (const int t : {0, 64, 149})
    EXPECT_TRUE(model_.curvature().row(t).transpose().isApprox(
        brute_force_form(motion_, t, measured_).diagonal(), 1e-5));
}

TEST_P(ErrorModelOf, GradientIsTheBruteForceFormTimesTheError) {
  Random random(4);
  Eigen::MatrixXd error(150, model_.channels());
  ErrorState state(model_);
  for (int c = 0; c < model_.channels(); ++c) {
    for (int t = 0; t < 150; ++t) error(t, c) = random.unit() - 0.5;
    state.add(c, error.col(c));
  }
  for (const int t : {0, 63, 64, 149}) {
    const Eigen::VectorXd expected =
        brute_force_form(motion_, t, measured_) * error.row(t).transpose();
    EXPECT_TRUE(state.gradient().row(t).transpose().isApprox(expected, 1e-5));
  }
}

TEST_P(ErrorModelOf, SumIsThatOfTheBruteForceFormOfSomeChannels) {
  const std::vector<int> channels = {0, 3, 4, model_.channels() - 1};
  struct Case {
    int first, size, first_counted, apart;
  };
  for (const auto& [first, size, first_counted, apart] :
       {Case{20, 11, 20, 2}, Case{21, 37, 22, 2}, Case{20, 70, 20, 4}}) {
    const Eigen::ArrayXf values = Eigen::ArrayXf::LinSpaced(size, 0.5F, 2);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 4);
    for (int t = first_counted; t < first + size; t += apart)
      expected += static_cast<double>(values(t - first) * values(t - first)) *
                  brute_force_form(motion_, t, measured_)(channels, channels);
    const ShortFunction function(first, size, values.data());
    Eigen::MatrixXf sums = Eigen::MatrixXf::Zero(5, 4);
    model_.sum_squares(channels, function, sums);
    EXPECT_TRUE(sums.topRows(4).isApprox(expected.cast<float>(), 1e-5F));
    EXPECT_TRUE(sums.bottomRows(1).isZero(0));
  }
}

TEST_P(ErrorModelOf, EnergyOfStepsAddsUpToTheQuadraticForm) {
  Random random(9);
  Eigen::MatrixXd error = Eigen::MatrixXd::Zero(150, model_.channels());
  ErrorState state(model_);
  for (int step = 0; step < 60; ++step) {
    const auto c = static_cast<int>(random.below(static_cast<std::uint64_t>(model_.channels())));
    Eigen::VectorXd delta(150);
    for (double& value : delta) value = random.unit() - 0.5;
    const double before = state.squared_eps();
    const double announced = state.change(c, delta);
    state.add(c, delta);
    error.col(c) += delta;
    EXPECT_NEAR(state.squared_eps() - before, announced, 1e-9);
  }
  const double whole = error.cwiseProduct(state.gradient()).sum() / 150;
  EXPECT_NEAR(state.squared_eps() / whole, 1, 1e-6);
}

TEST_P(ErrorModelOf, AgreesWithExactDistortionForSmallErrors) {
  Random random(11);
  Clip decoded = motion_.clip;
  ErrorState state(model_);
  for (int c = 0; c < model_.channels(); ++c) {
    const double size = is_rotation(motion_.skeleton.channel_kind(c)) ? 0.003 : 0.2;
    Eigen::VectorXd delta(150);
    for (double& value : delta) value = size * (random.unit() - 0.5);
    decoded.channels.col(c) += delta;
    state.add(c, delta);
  }
  const double exact = measure(motion_.skeleton, motion_.clip, decoded).eps(GetParam());
  EXPECT_NEAR(std::sqrt(state.squared_eps()) / exact, 1, 0.003);
}

/// smooth_motion() with a rig like those of games: every joint also translates, and one has no
/// channels.
Motion shifting_motion(int frames) {
  using enum ChannelKind;
  Skeleton skeleton;
  int parent = -1;
  for (const bool moves : {true, true, false, true})
    parent = skeleton.add({.name = "joint" + std::to_string(parent + 1),
                           .parent = parent,
                           .offset = {3, 20, 5},
                           .channels = moves ? std::vector{TranslationX, TranslationY, TranslationZ,
                                                           RotationZ, RotationX, RotationY}
                                             : std::vector<ChannelKind>{}});
  Motion motion{skeleton, {.channels = Eigen::MatrixXd(frames, skeleton.channel_count())}};
  for (int c = 0; c < skeleton.channel_count(); ++c)
    for (int t = 0; t < frames; ++t)
      motion.clip.channels(t, c) = std::sin(0.05 * t * (c + 1)) + 0.1 * c;
  return motion;
}

TEST(ErrorModel, GradientIsThatOfTheBruteForceFormWhereEveryJointShifts) {
  const Motion motion = shifting_motion(20);
  const MeasuredPoints measured = measured_points(motion.skeleton, Weighting::Shell);
  const ErrorModel model(motion.skeleton, motion.clip, measured);
  for (int c = 0; c < model.channels(); ++c) {
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(20, model.channels());
    model.add_to_gradient(c, Eigen::VectorXd::Ones(20), gradient);
    for (const int t : {0, 7, 8, 19}) {
      const Eigen::MatrixXd form = brute_force_form(motion, t, measured);
      EXPECT_LT((gradient.row(t).transpose() - form.col(c)).norm(), 1e-5 * form.norm());
      for (int other = 0; other < model.channels(); ++other)
        EXPECT_NEAR(static_cast<double>(model.entry(c, other)(t)), form(other, c),
                    1e-5 * form.norm());
    }
  }
}

TEST(ErrorModel, AddingAndTakingBackLeavesNothing) {
  const Motion motion = test::smooth_motion(70);
  const ErrorModel model(motion.skeleton, motion.clip, Weighting::BoneEnds);
  ErrorState state(model);
  const Eigen::VectorXd delta = motion.clip.channels.col(3);
  state.add(3, delta);
  const double once = state.squared_eps();
  const double steepest = state.gradient().cwiseAbs().maxCoeff();
  EXPECT_GT(once, 0);
  state.add(3, -delta);
  EXPECT_NEAR(state.squared_eps() / once, 0, 1e-6);
  EXPECT_NEAR(state.gradient().cwiseAbs().maxCoeff() / steepest, 0, 1e-6);
}

TEST(ErrorModel, ScalesOtherSignalsByTheirMovement) {
  const Motion motion = test::smooth_motion(70);
  const MeasuredPoints measured = measured_points(motion.skeleton, Weighting::BoneEnds);
  const ErrorModel of_channels(motion.skeleton, motion.clip, measured);
  // The root's first translation and its first rotation, about the world's z axis.
  SignalMoves moves{{{0, false}, {0, true}}, Eigen::MatrixXd(70, 6)};
  moves.axes.rowwise() = Eigen::Matrix<double, 1, 6>{3, 0, 0, 0, 0, 0.5};
  const ErrorModel model(motion.skeleton, motion.clip, measured, moves);
  EXPECT_EQ(model.channels(), 2);
  EXPECT_LT((model.curvature().col(0).array() - 9).abs().maxCoeff(), 1e-9);
  EXPECT_LT((model.curvature().col(1) - 0.25 * of_channels.curvature().col(3)).norm(), 1e-6);
}

}  // namespace
}  // namespace mocapress
