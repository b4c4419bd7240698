// SPDX-License-Identifier: MIT
#include "core/baselines/rivals.h"

#include <gtest/gtest.h>

#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Subsample, EveryDetailKeepsAtLeastOneMoreFrameAndTheLastOne) {
  const Motion motion = test::smooth_motion(101);
  const auto coder = kSubsample.analyse(motion, Weighting::BoneEnds);
  EXPECT_GT(coder->most_detail(), 10);
  for (int detail = 0; detail <= coder->most_detail(); ++detail) {
    const Clip clip = kSubsample.decode(motion.skeleton, 120, 101, coder->encode(detail));
    for (const int t : {0, 100})
      EXPECT_LT((clip.channels.row(t) - motion.clip.channels.row(t)).cwiseAbs().maxCoeff(), 0.01);
  }
}

TEST(Subsample, SlowMotionNeedsFewFrames) {
  Motion motion = test::smooth_motion(400);
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < 400; ++t) motion.clip.channels(t, c) = std::sin(0.01 * t + c);
  const auto coder = kSubsample.analyse(motion, Weighting::BoneEnds);
  const auto bytes = coder->encode(12);
  EXPECT_LT(bytes.size(), 900u);
  EXPECT_LT(
      measure(motion.skeleton, motion.clip, kSubsample.decode(motion.skeleton, 120, 400, bytes))
          .eps_bone_ends,
      0.5);
}

}  // namespace
}  // namespace mocapress
