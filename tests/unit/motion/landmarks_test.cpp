// SPDX-License-Identifier: MIT
#include "core/motion/landmarks.h"

#include <gtest/gtest.h>

#include "core/motion/forward_kinematics.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Landmarks, AreEveryJointThenEveryEndSite) {
  const auto points = landmarks(test::small_skeleton());
  ASSERT_EQ(points.size(), 8u + 2u);
  for (int j = 0; j < 8; ++j) EXPECT_EQ(points[static_cast<std::size_t>(j)].joint, j);
  EXPECT_EQ(points[8].name, "lhand end");
}

TEST(Landmarks, WeightsSumToOneAndFollowTheSegments) {
  const Skeleton skeleton = test::small_skeleton();
  const Eigen::VectorXd ends = landmark_weights(skeleton, Weighting::BoneEnds);
  const Eigen::VectorXd origins = landmark_weights(skeleton, Weighting::JointOrigins);
  EXPECT_NEAR(ends.sum(), 1, 1e-12);
  EXPECT_NEAR(origins.sum(), 1, 1e-12);
  EXPECT_EQ(ends(0), 0);                        // no segment ends at the root
  EXPECT_GT(ends(8), 0);                        // one ends at the left hand's end site
  EXPECT_EQ(origins(8), 0);                     // an end site drives nothing
  EXPECT_NEAR(origins(0) / ends(1), 1, 1e-12);  // the segment from root to spine
}

TEST(Landmarks, OfASkeletonWithoutLengthStillCount) {
  Skeleton point;
  point.add({.name = "p"});
  EXPECT_EQ(landmark_weights(point, Weighting::BoneEnds)(0), 1);
}

TEST(Landmarks, TracksAreForwardKinematicsFrameByFrame) {
  const Motion motion = test::smooth_motion(150);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const auto points = landmarks(motion.skeleton);
  Pose pose;
  for (const int t : {0, 63, 64, 149}) {
    compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Eigen::Vector3d position =
          tracks.block<1, 3>(t, 3 * static_cast<Eigen::Index>(p)).transpose();
      EXPECT_EQ(position, pose.to_world(points[p].joint, points[p].in_joint));
    }
  }
}

}  // namespace
}  // namespace mocapress
