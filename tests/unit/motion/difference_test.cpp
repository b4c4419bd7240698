// SPDX-License-Identifier: MIT
#include "core/motion/difference.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress::difference_test {
namespace {

constexpr int kFrames = 60;
constexpr double kRounding = 1e-9;  // cm

double farthest(const Motion& a, const Motion& b) {
  return (landmark_tracks(a.skeleton, a.clip) - landmark_tracks(b.skeleton, b.clip))
      .cwiseAbs()
      .maxCoeff();
}

/// A pose, and a clip of as many frames as the motion.
std::vector<Motion> bases() {
  const Motion clip = test::smooth_motion(kFrames, 7);
  return {frames_of(clip, 20, 1), clip};
}

TEST(Difference, AddedToItsBaseIsTheMotion) {
  const Motion motion = test::smooth_motion(kFrames);
  for (const Motion& base : bases())
    EXPECT_LT(farthest(sum_of(base, difference_to(base, motion)), motion), kRounding);
}

TEST(Difference, IsNothingBetweenAMotionAndItself) {
  const Motion motion = test::smooth_motion(kFrames);
  EXPECT_LT(difference_to(motion, motion).clip.channels.cwiseAbs().maxCoeff(), kRounding);
}

TEST(Difference, StandsOnTheBaseWhereTheSumStands) {
  const Motion motion = test::smooth_motion(kFrames);
  const Motion pose = bases().front();
  const Motion on_base = on_base_pose(pose, difference_to(pose, motion));
  EXPECT_LT(farthest(on_base, motion), kRounding);
  const Motion still = on_base_pose(pose, difference_to(pose, pose));
  EXPECT_LT(farthest(still, pose), kRounding);
}

TEST(Difference, NeedsABaseOfTheSameJointsAndFrames) {
  const Motion motion = test::smooth_motion(kFrames);
  EXPECT_THROW(difference_to(test::smooth_motion(kFrames - 1), motion), Error);
  Motion other = bases().front();
  other.skeleton = Skeleton();
  for (Joint joint : motion.skeleton.joints()) {
    joint.offset *= 1.1;
    other.skeleton.add(joint);
  }
  EXPECT_THROW(difference_to(other, motion), Error);
}

}  // namespace
}  // namespace mocapress::difference_test
