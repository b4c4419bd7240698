// SPDX-License-Identifier: MIT
#include "core/metrics/rate.h"

#include <gtest/gtest.h>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Rate, CountsFourBytesASampleAsThePaperDoes) {
  Clip running;  // the paper's run: 148 frames of 62 channels, 35.8 KB
  running.channels.resize(148, 62);
  EXPECT_EQ(raw_bytes(running), 36704u);
  EXPECT_DOUBLE_EQ(compression_ratio(running, 3670), 36704.0 / 3670);
}

TEST(Rate, SharesBitsOverJointsAndFrames) {
  const Motion motion = test::smooth_motion(10);
  EXPECT_DOUBLE_EQ(bits_per_joint_sample(motion, 80), 8.0);
}

}  // namespace
}  // namespace mocapress
