// SPDX-License-Identifier: MIT
#include "core/baselines/virtual_markers.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Clip from_markers(const Motion& motion, const VirtualMarkers& markers, double noise_cm) {
  Random random(1);
  Clip clip = motion.clip;
  Eigen::RowVectorXd frame = clip.channels.row(0);
  for (int t = 0; t < clip.frames(); ++t) {
    Eigen::RowVectorXd seen = markers.of(motion.clip.channels.row(t));
    for (double& value : seen) value += noise_cm * (2 * random.unit() - 1);
    const Eigen::RowVectorXd original = clip.channels.row(t);
    frame(markers.other_channels()) = original(markers.other_channels());
    markers.turn(seen, frame);
    clip.channels.row(t) = frame;
  }
  return clip;
}

TEST(VirtualMarkers, GiveEveryAngleBack) {
  const Motion motion = test::smooth_motion(200);
  const VirtualMarkers markers(motion.skeleton);
  const Clip clip = from_markers(motion, markers, 0);
  EXPECT_LT((clip.channels - motion.clip.channels).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(VirtualMarkers, PassNoiseOnWithoutMakingItWorse) {
  const Motion motion = test::smooth_motion(100);
  const VirtualMarkers markers(motion.skeleton);
  const Clip clip = from_markers(motion, markers, 0.5);
  EXPECT_LT(measure(motion.skeleton, motion.clip, clip).eps_bone_ends, 1.5);
}

TEST(VirtualMarkers, DoNotMoveWithTheRoot) {
  const Motion motion = test::smooth_motion(2);
  const VirtualMarkers markers(motion.skeleton);
  Eigen::RowVectorXd frame = motion.clip.channels.row(0);
  const Eigen::RowVectorXd before = markers.of(frame);
  for (int c = 0; c < 6; ++c) frame(c) += 0.7;
  EXPECT_LT((markers.of(frame) - before).norm(), 1e-10);
}

TEST(VirtualMarkers, EveryChannelIsEitherAnAngleOrAnother) {
  const Skeleton skeleton = test::small_skeleton();
  const VirtualMarkers markers(skeleton);
  EXPECT_EQ(std::ssize(markers.angles()) + std::ssize(markers.other_channels()),
            skeleton.channel_count());
  EXPECT_EQ(markers.other_channels(), (std::vector{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(markers.coordinates(), 9 * 7) << "every joint but the root turns";
}

}  // namespace
}  // namespace mocapress
