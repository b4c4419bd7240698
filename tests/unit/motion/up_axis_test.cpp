// SPDX-License-Identifier: MIT
#include "core/motion/up_axis.h"

#include <gtest/gtest.h>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

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
