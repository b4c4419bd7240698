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

using enum TranslationConvention;

/// A root alone, with this offset, at these places frame by frame.
Motion root_at(const Eigen::Vector3d& offset, const std::vector<Eigen::Vector3d>& places) {
  Motion motion;
  motion.skeleton.add({.name = "root",
                       .offset = offset,
                       .channels = {ChannelKind::TranslationX, ChannelKind::TranslationY,
                                    ChannelKind::TranslationZ}});
  motion.clip.channels.resize(std::ssize(places), 3);
  for (std::size_t t = 0; t < places.size(); ++t)
    motion.clip.channels.row(static_cast<Eigen::Index>(t)) = places[t].transpose();
  return motion;
}

TEST(TranslationConvention, JointsFollowTheNearerReadingOfTheirValues) {
  const auto adds = guess_translation(two_translating({0, 3, 0}, {0, 0.5, 0}));
  EXPECT_EQ(adds.others->convention, Adds);
  EXPECT_TRUE(adds.others->clear);
  const auto replaces = guess_translation(two_translating({0, 0, 0}, {1, 20, 5}));
  EXPECT_EQ(replaces.others->convention, Replaces);
}

TEST(TranslationConvention, TheRootFollowsJointsThatAreClear) {
  EXPECT_EQ(guess_translation(two_translating({0, 0, 0}, {1, 20, 5})).roots->convention, Replaces);
  EXPECT_EQ(guess_translation(two_translating({0, 60, 0}, {0, 0, 0})).roots->convention, Adds);
}

TEST(TranslationConvention, ARootThatBeginsAtItsOffsetReplacesIt) {
  // The root walks back along its OFFSET, far enough for the mean to say "adds".
  const Motion walk = root_at({100, 90, 40}, {{100, 90, 40}, {-100, 91, -40}, {-300, 89, -90}});
  EXPECT_EQ(guess_translation(walk).roots->convention, Replaces);
  EXPECT_TRUE(guess_translation(walk).roots->clear);
  EXPECT_EQ(guess_translation(two_translating({0, 100, 0}, {0, 0, 0})).roots->convention, Replaces);
}

TEST(TranslationConvention, IsTheSameForAllClipsOfADataSet) {
  const Eigen::Vector3d offset(12, 95, -8);
  for (const Eigen::Vector3d& begin : {offset, Eigen::Vector3d(300, 94, 20)})
    EXPECT_EQ(guess_translation(root_at(offset, {begin, begin + Eigen::Vector3d(5, 1, -60)}))
                  .roots->convention,
              Replaces)
        << begin.transpose();
}

TEST(TranslationConvention, IgnoresHowFarTheRootWalksSideways) {
  EXPECT_EQ(guess_translation(root_at({0, 100, 0}, {{500, 95, -300}})).roots->convention, Replaces);
  EXPECT_EQ(guess_translation(root_at({30, 100, 0}, {{900, 2, 0}})).roots->convention, Adds);
  EXPECT_EQ(guess_translation(root_at({30, 0, 100}, {{900, 0, 2}}), UpAxis::Z).roots->convention,
            Adds);
}

TEST(TranslationConvention, IsThatOfBlenderAndMotionBuilderWhereNeitherFits) {
  for (const double height : {-90.0, 40.0, 60.0, 300.0}) {
    const auto guess = guess_translation(root_at({0, 100, 0}, {{0, height, 0}})).roots;
    EXPECT_EQ(guess->convention, Replaces) << height;
    EXPECT_FALSE(guess->clear) << height;
  }
  const auto joints = guess_translation(two_translating({0, 0, 0}, {0, 10, 2})).others;
  EXPECT_EQ(joints->convention, Replaces);
  EXPECT_FALSE(joints->clear);
}

TEST(TranslationConvention, HasNothingToGuessWithoutOffsets) {
  Motion motion;
  Joint root;
  root.channels = {ChannelKind::TranslationX};
  root.offset = {0, 100, 0};  // no channel along it
  motion.skeleton.add(root);
  motion.clip.channels = Eigen::MatrixXd::Ones(3, 1);
  EXPECT_FALSE(guess_translation(motion).roots);
  EXPECT_FALSE(guess_translation(motion).others);
}

TEST(CmPerUnit, KeepsCentimetresThatArePlausible) {
  for (const double height : {100.0, 150.0, 260.0}) EXPECT_EQ(guess_cm_per_unit(height), 1);
  EXPECT_EQ(guess_cm_per_unit(0), 1);
}

TEST(CmPerUnit, FindsTheUnitOfAPerson) {
  EXPECT_EQ(guess_cm_per_unit(1.75), 100);
  EXPECT_EQ(guess_cm_per_unit(1680), 0.1);
  EXPECT_EQ(guess_cm_per_unit(67), 2.54);
  EXPECT_EQ(guess_cm_per_unit(29.5), 2.54 / 0.45);
  EXPECT_EQ(guess_cm_per_unit(16.6), 10);
}

/// The nearest unit once took two bodies 3 % apart for 117 cm and 252 cm.
TEST(CmPerUnit, NeverJumpsBetweenNeighbours) {
  for (double height = 0.01; height < 1e5; height *= 1.01) {
    const double here = guess_cm_per_unit(height);
    const double next = guess_cm_per_unit(1.01 * height);
    EXPECT_LE(next, here) << height;
    EXPECT_GE(next, 0.97 * here) << height;
    EXPECT_GE(here * height, 99.99);
    EXPECT_LE(here * height, 260.01);
  }
  EXPECT_NEAR(guess_cm_per_unit(46), 3.7, 0.2);
}

TEST(RateFromFrameTime, UndoesTheRoundingOfTheDigitsWritten) {
  EXPECT_EQ(rate_from_frame_time(.0083333), 120);
  EXPECT_EQ(rate_from_frame_time(0.016667), 60);
  EXPECT_EQ(rate_from_frame_time(0.033333), 30);
  EXPECT_EQ(rate_from_frame_time(0.041667), 24);
  EXPECT_NEAR(*rate_from_frame_time(1.001 / 30), 29.97, 1e-4);
}

TEST(RateFromFrameTime, ReadsAFrameTimeAboveOneSecondAsFramesPerSecond) {
  EXPECT_EQ(rate_from_frame_time(120), 120);
  EXPECT_FALSE(rate_from_frame_time(0));
  EXPECT_FALSE(rate_from_frame_time(-0.01));
  EXPECT_FALSE(rate_from_frame_time(1e-9));
}

}  // namespace
}  // namespace mocapress
