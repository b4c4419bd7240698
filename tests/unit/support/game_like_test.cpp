// SPDX-License-Identifier: MIT
#include "tests/support/game_like.h"

#include <gtest/gtest.h>

#include "core/codec/encode/encoder.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(GameLike, EveryJointIsWhereItWas) {
  const Motion motion = test::smooth_motion(200);
  const Motion game = test::game_like(motion);
  const Eigen::MatrixXd there =
      point_tracks(motion.skeleton, joint_origins(motion.skeleton), motion.clip);
  const Eigen::MatrixXd found =
      point_tracks(game.skeleton, joint_origins(game.skeleton), game.clip).rightCols(there.cols());
  EXPECT_LT((there - found).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(GameLike, TheRootIsOnTheFloorAndNoAngleJumps) {
  const Motion game = test::game_like(test::smooth_motion(200));
  EXPECT_EQ(game.skeleton.channel_count(), 6 * game.skeleton.joint_count());
  EXPECT_TRUE(game.clip.channels.col(1).isZero(0));
  for (int c = 0; c < game.skeleton.channel_count(); ++c)
    if (is_rotation(game.skeleton.channel_kind(c))) {
      const auto angles = game.clip.channels.col(c);
      EXPECT_LT((angles.tail(199) - angles.head(199)).cwiseAbs().maxCoeff(), 0.6) << c;
    }
}

TEST(GameLike, HasABodyThatIsMeasuredAndPromised) {
  const Motion game = test::game_like(test::smooth_motion(200));
  EXPECT_FALSE(measured_points(game.skeleton, Weighting::Surface).points.empty());
  const Encoding encoding = Encoder(game).encode({.method = Method::ClosedLoop,
                                                  .weighting = Weighting::Surface,
                                                  .target = {Target::Kind::Error, 0.5}});
  EXPECT_LE(encoding.distortion.surface.rms, 0.5);
  EXPECT_GT(encoding.distortion.surface.rms, 0.45);
}

}  // namespace
}  // namespace mocapress
