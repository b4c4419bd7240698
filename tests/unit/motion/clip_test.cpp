// SPDX-License-Identifier: MIT
#include "core/motion/clip.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Motion turning(const std::vector<double>& angles) {
  Motion motion;
  motion.skeleton.add(
      {.name = "root", .channels = {ChannelKind::TranslationX, ChannelKind::RotationX}});
  motion.clip.channels.resize(std::ssize(angles), 2);
  for (std::size_t t = 0; t < angles.size(); ++t)
    motion.clip.channels.row(static_cast<Eigen::Index>(t)).setConstant(angles[t]);
  return motion;
}

TEST(UnwrapAngles, RestoresASteadyTurnWrappedAtHalfATurn) {
  std::vector<double> wrapped;
  for (int t = 0; t < 100; ++t) wrapped.push_back(std::remainder(0.3 * t, kTurn));
  Motion motion = turning(wrapped);
  unwrap_angles(motion.skeleton, motion.clip);
  for (int t = 0; t < 100; ++t) EXPECT_NEAR(motion.clip.channels(t, 1), 0.3 * t, 1e-9);
}

TEST(UnwrapAngles, LeavesTranslationsAndSmallStepsAlone) {
  Motion motion = turning({0, 3, 7, -9, 0});
  const Eigen::VectorXd before = motion.clip.channels.col(0);
  unwrap_angles(motion.skeleton, motion.clip);
  EXPECT_EQ(motion.clip.channels.col(0), before);
  Motion small = test::smooth_motion(50);
  const Eigen::MatrixXd smooth = small.clip.channels;
  unwrap_angles(small.skeleton, small.clip);
  EXPECT_EQ(small.clip.channels, smooth);
}

TEST(UnwrapAngles, ChangesByWholeTurnsOnly) {
  Motion motion = turning({0.1, 5, -4, 20, 0.2, 9});
  const Eigen::MatrixXd before = motion.clip.channels;
  unwrap_angles(motion.skeleton, motion.clip);
  for (int t = 0; t < motion.clip.frames(); ++t) {
    const double turns = (motion.clip.channels(t, 1) - before(t, 1)) / kTurn;
    EXPECT_NEAR(turns, std::round(turns), 1e-9);
    if (t == 0) continue;
    EXPECT_LE(std::abs(motion.clip.channels(t, 1) - motion.clip.channels(t - 1, 1)),
              kTurn / 2 + 1e-9);
  }
}

TEST(UnwrapAngles, AcceptsAClipWithoutFrames) {
  Motion motion = turning({});
  EXPECT_NO_THROW(unwrap_angles(motion.skeleton, motion.clip));
}

TEST(UpAxis, MovesEveryPointAlike) {
  const Motion motion = test::smooth_motion(20);
  const Motion turned = with_up_axis(motion, UpAxis::Z, UpAxis::Y);
  const Eigen::MatrixXd was = landmark_tracks(motion.skeleton, motion.clip);
  const Eigen::MatrixXd is = landmark_tracks(turned.skeleton, turned.clip);
  for (Eigen::Index p = 0; p < was.cols(); p += 3) {
    EXPECT_LT((is.col(p) - was.col(p)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((is.col(p + 1) - was.col(p + 2)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((is.col(p + 2) + was.col(p + 1)).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(UpAxis, ThereAndBackGivesTheSameNumbers) {
  const Motion motion = test::smooth_motion(20);
  for (const UpAxis from : {UpAxis::Y, UpAxis::Z}) {
    const UpAxis to = from == UpAxis::Y ? UpAxis::Z : UpAxis::Y;
    const Motion back = with_up_axis(with_up_axis(motion, from, to), to, from);
    EXPECT_EQ(back.clip.channels, motion.clip.channels);
    for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
      EXPECT_EQ(back.skeleton.joint(j).channels, motion.skeleton.joint(j).channels);
      EXPECT_EQ(back.skeleton.joint(j).offset, motion.skeleton.joint(j).offset);
      EXPECT_EQ(back.skeleton.joint(j).joint_from_axes, motion.skeleton.joint(j).joint_from_axes);
    }
  }
}

}  // namespace
}  // namespace mocapress
