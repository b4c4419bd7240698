// SPDX-License-Identifier: MIT
#include "core/select/error_sweep.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/test_motion.h"

namespace mocapress::error_sweep_test {
namespace {

constexpr int kFrames = 90;

Eigen::MatrixXd any_errors(int channels, std::uint64_t seed) {
  Random random(seed);
  return Eigen::MatrixXd::NullaryExpr(kFrames, channels, [&] { return random.unit() - 0.5; });
}

class ErrorSweepOf : public testing::Test {
 protected:
  /// Gives a joint in the middle more weight, without turns.
  void add_term() {
    const int joint = motion_.skeleton.joint_count() / 2;
    const Eigen::MatrixXd tracks = landmark_tracks(motion_.skeleton, motion_.clip);
    model_.add({.joints = {joint},
                .places = tracks.middleCols(Eigen::Index{3} * joint, 3),
                .angles = {},
                .turns = Eigen::MatrixXd(kFrames, 0),
                .weights = Eigen::MatrixXd::Constant(kFrames, 1, 3)});
  }

  /// Compares the gradient of every channel, each changed right after its visit, with an eager sum
  /// over all related channels.
  void compare() {
    const Eigen::MatrixXd errors = any_errors(model_.channels(), 1);
    const Eigen::MatrixXd changes = any_errors(model_.channels(), 2);
    Eigen::MatrixXd eager = Eigen::MatrixXd::Zero(kFrames, model_.channels());
    for (int c = 0; c < model_.channels(); ++c) model_.add_to_gradient(c, errors.col(c), eager);
    const double size = eager.norm() / std::sqrt(model_.channels());
    Eigen::MatrixXf in_floats = errors.cast<float>();
    ErrorSweep sweep(model_, in_floats);
    const Eigen::VectorXd energies = errors.cwiseProduct(eager).rowwise().sum();
    EXPECT_LT((sweep.energies().matrix().cast<double>() - energies).norm(), 1e-5 * energies.norm());
    Eigen::MatrixXf at_once;
    model_.find_gradient(in_floats, at_once);
    EXPECT_LT((at_once.topRows(kFrames).cast<double>() - eager).norm(), 1e-5 * eager.norm());
    for (int c = 0; c < model_.channels(); ++c) {
      EXPECT_LT((sweep.next().matrix().cast<double>() - eager.col(c)).norm(), 1e-5 * size)
          << "channel " << c;
      in_floats.col(c) += changes.col(c).cast<float>();
      sweep.add(changes.col(c).cast<float>().array());
      model_.add_to_gradient(c, changes.col(c), eager);
    }
  }

  const Motion motion_ = test::smooth_motion(kFrames);
  ErrorModel model_{motion_.skeleton, motion_.clip, Weighting::BoneEnds};
};

TEST_F(ErrorSweepOf, FollowsChangesOnTheWayAsTheEagerGradientDoes) {
  compare();
}

TEST_F(ErrorSweepOf, HeedsTermsOfPoints) {
  add_term();
  compare();
}

TEST_F(ErrorSweepOf, BeginsAnewWithTheErrorsAsTheyAre) {
  Eigen::MatrixXf errors = any_errors(model_.channels(), 1).cast<float>();
  ErrorSweep sweep(model_, errors);
  for (int c = 0; c < model_.channels(); ++c) sweep.next();
  EXPECT_TRUE(sweep.is_under_way());
  errors = any_errors(model_.channels(), 2).cast<float>();
  sweep.restart();
  EXPECT_FALSE(sweep.is_under_way());
  ErrorSweep fresh(model_, errors);
  EXPECT_TRUE((sweep.energies() == fresh.energies()).all());
  for (int c = 0; c < model_.channels(); ++c) EXPECT_TRUE((sweep.next() == fresh.next()).all());
}

TEST_F(ErrorSweepOf, WithoutErrorHasNoGradient) {
  const Eigen::MatrixXf none = Eigen::MatrixXf::Zero(kFrames, model_.channels());
  ErrorSweep sweep(model_, none);
  for (int c = 0; c < model_.channels(); ++c) EXPECT_TRUE((sweep.next() == 0).all());
}

}  // namespace
}  // namespace mocapress::error_sweep_test
