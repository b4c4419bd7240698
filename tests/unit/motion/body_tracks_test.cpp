// SPDX-License-Identifier: MIT
#include "core/motion/body_tracks.h"

#include <gtest/gtest.h>

#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(VisitTracks, GivesTheTracksOfALongClipInTimeAndWhole) {
  const Motion motion = test::smooth_motion(20'000);
  const Eigen::MatrixXd whole = body_tracks(motion.skeleton, motion.clip);
  int next = 0;
  int blocks = 0;
  visit_tracks(motion.skeleton, motion.clip, [&](int first, const Eigen::MatrixXd& tracks) {
    ASSERT_EQ(first, next);
    EXPECT_TRUE(tracks.isApprox(whole.middleRows(first, tracks.rows()), 1e-12));
    next += static_cast<int>(tracks.rows());
    ++blocks;
  });
  EXPECT_EQ(next, 20'000);
  EXPECT_GT(blocks, 1);
}

TEST(VisitTracks, MeasuringInBlocksIsMeasuringTheWhole) {
  const Motion motion = test::smooth_motion(20'000);
  const Clip other = test::smooth_motion(20'000, 2).clip;
  const Eigen::MatrixXd original = body_tracks(motion.skeleton, motion.clip);
  const Distortion in_blocks = measure(motion.skeleton, original, other);
  const Distortion whole = measure(motion.skeleton, original, body_tracks(motion.skeleton, other));
  EXPECT_NEAR(in_blocks.eps_bone_ends, whole.eps_bone_ends, 1e-9);
  EXPECT_EQ(in_blocks.max.frame, whole.max.frame);
  EXPECT_TRUE(in_blocks.distances.isApprox(whole.distances, 1e-6F));
}

}  // namespace
}  // namespace mocapress
