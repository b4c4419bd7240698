// SPDX-License-Identifier: MIT
#include "core/metrics/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/motion/body_tracks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Comparison compared_with(const Clip& decoded) {
  const Motion original = test::smooth_motion(20);
  return compare(original, body_tracks(original.skeleton, original.clip), decoded, {});
}

TEST(Comparison, FindsNoErrorOfAMotionAgainstItself) {
  EXPECT_EQ(compared_with(test::smooth_motion(20).clip).distortion.max.cm, 0);
}

TEST(Comparison, HasTheErrorsOfDistortion) {
  const Motion original = test::smooth_motion(20);
  const Clip other = test::smooth_motion(20, 2).clip;
  const Distortion alone = measure(original.skeleton, original.clip, other);
  const Comparison found = compared_with(other);
  EXPECT_GT(found.distortion.max.cm, 0);
  EXPECT_EQ(found.distortion.max.cm, alone.max.cm);
  EXPECT_EQ(found.distortion.eps_bone_ends, alone.eps_bone_ends);
}

TEST(Comparison, TellsBothShapesWhereTheyDiffer) {
  try {
    compared_with(test::smooth_motion(21).clip);
    FAIL() << "21 frames are not 20";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("21 frames of"));
    EXPECT_THAT(error.what(), testing::HasSubstr("original 20 frames of"));
  }
}

}  // namespace
}  // namespace mocapress
