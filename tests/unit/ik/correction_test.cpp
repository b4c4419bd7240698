// SPDX-License-Identifier: MIT
#include "core/ik/correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/base/error.h"
#include "core/feet/feet.h"
#include "core/motion/landmarks.h"
#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

constexpr IkSolver kSolvers[] = {IkSolver::CyclicDescent, IkSolver::NearestPose};

class Correction : public testing::Test {
 protected:
  /// Half a second of walking, with a slow wave added to every rotation except the root's.
  void SetUp() override {
    motion_.clip.channels.conservativeResize(60, Eigen::NoChange);
    damaged_ = motion_.clip;
    for (int c = 6; c < motion_.skeleton.channel_count(); ++c)
      for (int t = 0; t < damaged_.frames(); ++t)
        damaged_.channels(t, c) += 0.03 * std::sin(0.1 * t + c);
  }

  Eigen::MatrixXd tracks_of(const Clip& clip) const {
    return effector_tracks(landmark_tracks(motion_.skeleton, clip), feet_);
  }

  Motion motion_ = samples::walk_clip();
  Clip damaged_;
  std::vector<Effector> feet_ = find_feet(motion_.skeleton);
};

TEST_F(Correction, BringsTheFeetToWhereTheOriginalHasThem) {
  const Eigen::MatrixXd differences = tracks_of(motion_.clip) - tracks_of(damaged_);
  ASSERT_GT(differences.cwiseAbs().maxCoeff(), 1);
  for (const IkSolver solver : kSolvers) {
    Clip corrected = damaged_;
    const CorrectionReport report =
        apply_correction(motion_.skeleton, feet_, solver, differences, corrected);
    const double off = (tracks_of(corrected) - tracks_of(motion_.clip)).rowwise().norm().maxCoeff();
    EXPECT_LE(off, 2 * report.worst_miss_cm + 1e-9) << name(solver);
    EXPECT_LE(report.worst_miss_cm, solver == IkSolver::NearestPose ? kReachedCm : 0.3);
    EXPECT_EQ(report.unreached > 0, report.worst_miss_cm > kReachedCm);
  }
}

TEST_F(Correction, TurnsNothingButTheLegs) {
  const Eigen::MatrixXd differences = tracks_of(motion_.clip) - tracks_of(damaged_);
  Clip corrected = damaged_;
  apply_correction(motion_.skeleton, feet_, IkSolver::NearestPose, differences, corrected);
  for (int c = 0; c < motion_.skeleton.channel_count(); ++c) {
    const auto is_in_chain = [&](const Effector& foot) {
      return std::count(foot.chain.begin(), foot.chain.end(), motion_.skeleton.channel_joint(c)) &&
             is_rotation(motion_.skeleton.channel_kind(c));
    };
    const bool may_turn = std::any_of(feet_.begin(), feet_.end(), is_in_chain);
    EXPECT_EQ(corrected.channels.col(c) != damaged_.channels.col(c), may_turn) << c;
  }
}

TEST_F(Correction, MovesNoJointFurtherThanTheFeet) {
  const Eigen::MatrixXd differences = tracks_of(motion_.clip) - tracks_of(damaged_);
  Clip corrected = damaged_;
  apply_correction(motion_.skeleton, feet_, IkSolver::NearestPose, differences, corrected);
  const Eigen::MatrixXd moved =
      landmark_tracks(motion_.skeleton, corrected) - landmark_tracks(motion_.skeleton, damaged_);
  for (const Effector& foot : feet_)
    for (const int joint : foot.chain)
      EXPECT_LE(moved.middleCols<3>(3 * joint).rowwise().norm().maxCoeff(),
                1.1 * differences.cwiseAbs().maxCoeff() * std::sqrt(3));
}

TEST_F(Correction, NoDifferencesChangeNothing) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(60, 3 * std::ssize(feet_));
  // Rounded like decoded values.
  damaged_.channels = damaged_.channels.cast<float>().cast<double>().eval();
  for (const IkSolver solver : kSolvers) {
    Clip corrected = damaged_;
    apply_correction(motion_.skeleton, feet_, solver, none, corrected);
    EXPECT_EQ(corrected.channels, damaged_.channels);
  }
}

TEST_F(Correction, SaysWhenATargetIsOutOfReach) {
  const Eigen::MatrixXd far = Eigen::MatrixXd::Constant(60, 3 * std::ssize(feet_), 200.0);
  for (const IkSolver solver : kSolvers) {
    Clip corrected = damaged_;
    const CorrectionReport report =
        apply_correction(motion_.skeleton, feet_, solver, far, corrected);
    EXPECT_EQ(report.unreached, 2 * 60);  // both legs at every frame
    EXPECT_GT(report.worst_miss_cm, 100);
    EXPECT_TRUE(corrected.channels.allFinite());
  }
}

TEST(CheckEffectors, RefusesAJointThatStandsTwice) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  const Effector foot = find_feet(skeleton).front();
  EXPECT_THROW(check_effectors(skeleton, {foot, foot}), Error);
  EXPECT_NO_THROW(check_effectors(skeleton, find_feet(skeleton)));
}

TEST(EffectorBetween, IsWhatEffectorAtFoundGivenItsEnds) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  for (const Effector& foot : find_feet(skeleton)) {
    EXPECT_EQ(effector_between(skeleton, foot.chain.front(), foot.joint).chain, foot.chain);
    EXPECT_THROW(effector_between(skeleton, foot.joint, foot.chain.front()), Error);
    EXPECT_THROW(effector_between(skeleton, foot.joint, foot.joint), Error);
  }
}

TEST(Knee, IsTheSecondJointOfALeg) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  for (const Effector& foot : find_feet(skeleton))
    EXPECT_NE(skeleton.joint(knee_of(foot)).name.find("tibia"), std::string::npos);
}

TEST(Knee, FastestTurnIsTheOneThatWasPlanted) {
  Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  motion.clip.channels.setZero();
  EXPECT_EQ(fastest_knee(motion.skeleton, feet, motion.clip), 0);
  const int channel = motion.skeleton.first_channel(knee_of(feet.back()));
  motion.clip.channels.col(channel).tail(10).setConstant(0.25);
  EXPECT_NEAR(fastest_knee(motion.skeleton, feet, motion.clip), 0.25 * motion.clip.sample_rate_hz,
              1e-9);
}

TEST(Knee, AWholeTurnIsNoTurn) {
  Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  const double before = fastest_knee(motion.skeleton, feet, motion.clip);
  const int channel = motion.skeleton.first_channel(knee_of(feet.front()));
  motion.clip.channels.col(channel).tail(10).array() += 2 * std::numbers::pi;
  EXPECT_NEAR(fastest_knee(motion.skeleton, feet, motion.clip), before, 1e-9);
}

TEST(Knee, IsTheSameInBlocks) {
  const Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  KneeSpeed speed(motion.skeleton, feet);
  for (int first = 0; first < motion.clip.frames(); first += 13)
    speed.add({motion.clip.sample_rate_hz,
               motion.clip.channels.middleRows(first, std::min(13, motion.clip.frames() - first))});
  EXPECT_EQ(speed.fastest(), fastest_knee(motion.skeleton, feet, motion.clip));
  EXPECT_GT(speed.fastest(), 0);
}

}  // namespace
}  // namespace mocapress
