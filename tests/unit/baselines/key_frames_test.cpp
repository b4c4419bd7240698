// SPDX-License-Identifier: MIT
#include "core/baselines/rivals.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(KeyFrames, ErrorFallsAndBytesGrowWithDetail) {
  const Motion motion = test::smooth_motion(300);
  const auto coder = kKeyFrames.analyse(motion, Weighting::BoneEnds);
  std::size_t bytes_before = 0;
  double error_before = 1e9;
  for (const int detail : {20, 80, 320, 1280}) {
    const auto bytes = coder->encode(detail);
    const Clip clip = kKeyFrames.decode(motion.skeleton, 120, 300, bytes);
    const double error = measure(motion.skeleton, motion.clip, clip).eps_bone_ends;
    EXPECT_GT(bytes.size(), bytes_before) << detail;
    EXPECT_LT(error, error_before) << detail;
    bytes_before = bytes.size();
    error_before = error;
  }
  EXPECT_LT(error_before, 0.1);
}

TEST(KeyFrames, LinesNeedTwoKeys) {
  Motion motion = test::smooth_motion(200);
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < 200; ++t) motion.clip.channels(t, c) = 0.001 * t * (c % 2);
  const auto coder = kKeyFrames.analyse(motion, Weighting::BoneEnds);
  EXPECT_LT(coder->encode(2000).size(),
            40u * static_cast<std::size_t>(motion.clip.channels.cols()));
}

TEST(KeyFrames, KeepClipsOfOneFrame) {
  const Motion motion = test::smooth_motion(1);
  const auto coder = kKeyFrames.analyse(motion, Weighting::BoneEnds);
  const Clip clip = kKeyFrames.decode(motion.skeleton, 120, 1, coder->encode(100));
  EXPECT_TRUE(clip.channels.isApprox(motion.clip.channels, 1e-5));
}

TEST(KeyFrames, RefuseKeysOutsideTheClip) {
  const Motion motion = test::smooth_motion(60);
  const auto coder = kKeyFrames.analyse(motion, Weighting::BoneEnds);
  const auto bytes = coder->encode(500);
  EXPECT_THROW(kKeyFrames.decode(motion.skeleton, 120, 40, bytes), FormatError);
  EXPECT_THROW(kKeyFrames.decode(motion.skeleton, 120, 80, bytes), FormatError);
}

}  // namespace
}  // namespace mocapress
