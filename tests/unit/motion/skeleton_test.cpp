// SPDX-License-Identifier: MIT
#include "core/motion/skeleton.h"

#include <gtest/gtest.h>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Skeleton, NumbersChannelsJointByJoint) {
  const Skeleton skeleton = test::small_skeleton();
  EXPECT_EQ(skeleton.channel_count(), 6 + 3 + 2 * (3 + 1 + 2));
  EXPECT_EQ(skeleton.first_channel(1), 6);
  EXPECT_EQ(skeleton.channel_joint(5), 0);
  EXPECT_EQ(skeleton.channel_joint(6), 1);
  EXPECT_EQ(skeleton.channel_kind(3), ChannelKind::RotationZ);
  EXPECT_EQ(skeleton.channel_name(6), "spine.rx");
}

TEST(Skeleton, FindsJointsByName) {
  const Skeleton skeleton = test::small_skeleton();
  EXPECT_EQ(skeleton.joint(skeleton.find("rhand")).name, "rhand");
  EXPECT_EQ(skeleton.find("tail"), -1);
}

TEST(Skeleton, HasASegmentForEveryChildAndEndSite) {
  const Skeleton skeleton = test::small_skeleton();
  int end_sites = 0;
  for (const Segment& segment : skeleton.segments()) {
    EXPECT_NEAR(segment.length, segment.end_in_joint.norm(), 1e-12);
    if (segment.child < 0)
      ++end_sites;
    else
      EXPECT_EQ(skeleton.joint(segment.child).parent, segment.joint);
  }
  EXPECT_EQ(std::ssize(skeleton.segments()), skeleton.joint_count() - 1 + 2);
  EXPECT_EQ(end_sites, 2);
}

TEST(Skeleton, SumsTheLengthsAJointDrives) {
  const Skeleton skeleton = test::small_skeleton();
  const double arm = Eigen::Vector2d(18, 25).norm();
  EXPECT_NEAR(skeleton.driven_lengths()[1], 2 * arm, 1e-12);
  EXPECT_NEAR(skeleton.driven_lengths()[0], 20, 1e-12);
}

}  // namespace
}  // namespace mocapress
