// SPDX-License-Identifier: MIT
#include "core/formats/bvh_conventions.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

/// A root and a child, each with an offset and three translation channels, both held still.
Motion two_translating(const Eigen::Vector3d& root, const Eigen::Vector3d& child) {
  Motion motion;
  Joint joint;
  joint.offset = {0, 100, 0};
  joint.channels = {ChannelKind::TranslationX, ChannelKind::TranslationY,
                    ChannelKind::TranslationZ};
  motion.skeleton.add(joint);
  joint.parent = 0;
  joint.offset = {0, 20, 5};
  motion.skeleton.add(joint);
  motion.clip.channels.resize(1, 6);
  motion.clip.channels << root.transpose(), child.transpose();
  return motion;
}

TEST(TranslationConvention, FollowsTheJointsBelowTheRoot) {
  const auto adds = guess_translation(two_translating({0, 100, 0}, {0, 0.5, 0}));
  EXPECT_EQ(adds->convention, TranslationConvention::Adds);
  EXPECT_TRUE(adds->clear);
  const auto replaces = guess_translation(two_translating({0, 0, 0}, {1, 20, 5}));
  EXPECT_EQ(replaces->convention, TranslationConvention::Replaces);
}

TEST(TranslationConvention, IgnoresHowFarTheRootWalksSideways) {
  Motion motion = two_translating({500, 95, -300}, {0, 0, 0});
  Skeleton root_only;
  root_only.add(motion.skeleton.joint(0));
  motion = {root_only, {120, motion.clip.channels.leftCols(3)}};
  EXPECT_EQ(guess_translation(motion)->convention, TranslationConvention::Replaces);
}

TEST(TranslationConvention, SaysWhenNeitherFits) {
  EXPECT_FALSE(guess_translation(two_translating({0, 0, 0}, {0, 10, 2}))->clear);
}

TEST(TranslationConvention, HasNothingToGuessWithoutOffsets) {
  Motion motion;
  Joint root;
  root.channels = {ChannelKind::TranslationX};
  root.offset = {0, 100, 0};  // no channel along it
  motion.skeleton.add(root);
  motion.clip.channels = Eigen::MatrixXd::Ones(3, 1);
  EXPECT_FALSE(guess_translation(motion));
}

TEST(CmPerUnit, KeepsCentimetresThatArePlausible) {
  for (const double height : {80.0, 150.0, 260.0}) EXPECT_EQ(guess_cm_per_unit(height), 1);
  EXPECT_EQ(guess_cm_per_unit(0), 1);
}

TEST(CmPerUnit, FindsTheUnitOfAPerson) {
  EXPECT_EQ(guess_cm_per_unit(1.75), 100);
  EXPECT_EQ(guess_cm_per_unit(1680), 0.1);
  EXPECT_EQ(guess_cm_per_unit(67), 2.54);
  EXPECT_EQ(guess_cm_per_unit(29.5), 2.54 / 0.45);
  EXPECT_EQ(guess_cm_per_unit(16.6), 10);
}

TEST(RateFromFrameTime, UndoesTheRoundingOfTheDigitsWritten) {
  EXPECT_EQ(rate_from_frame_time(.0083333), 120);
  EXPECT_EQ(rate_from_frame_time(0.016667), 60);
  EXPECT_EQ(rate_from_frame_time(0.033333), 30);
  EXPECT_EQ(rate_from_frame_time(0.041667), 24);
  EXPECT_NEAR(*rate_from_frame_time(1.001 / 30), 29.97, 1e-4);
}

TEST(RateFromFrameTime, TakesSecondsAFrameNobodyMeansForFramesASecond) {
  EXPECT_EQ(rate_from_frame_time(120), 120);
  EXPECT_FALSE(rate_from_frame_time(0));
  EXPECT_FALSE(rate_from_frame_time(-0.01));
  EXPECT_FALSE(rate_from_frame_time(1e-9));
}

}  // namespace
}  // namespace mocapress
