// SPDX-License-Identifier: MIT
#include "core/motion/skeleton.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

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

TEST(ShortestTurn, BringsOneDirectionToAnotherAndLeavesWhatIsAcrossBoth) {
  using Eigen::Vector3d;
  for (const Vector3d& from : {Vector3d(1, 0, 0), Vector3d(0, -3, 0), Vector3d(1, 2, -2)})
    for (const Vector3d& to : {Vector3d(2, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 5, 0),
                               Vector3d(-2, -4, 4), Vector3d(1, 2, -2.0001)}) {
      const Eigen::Matrix3d turn = shortest_turn(from, to);
      EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-9);
      EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      EXPECT_GT(turn.determinant(), 0);
      const Vector3d across = from.cross(to);
      EXPECT_LT((turn * across - across).norm(), 1e-9 * from.norm() * to.norm());
    }
}

}  // namespace
}  // namespace mocapress
