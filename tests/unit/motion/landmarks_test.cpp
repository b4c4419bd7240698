// SPDX-License-Identifier: MIT
#include "core/motion/landmarks.h"

#include <gtest/gtest.h>

#include "core/motion/body.h"
#include "core/motion/body_tracks.h"
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

TEST(Landmarks, CountWithoutBoneLengths) {
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
      EXPECT_LT((position - pose.to_world(points[p].joint, points[p].in_joint)).norm(), 1e-11);
    }
  }
}

TEST(MeasuredPoints, WeighOneInEveryWeighting) {
  Skeleton point;
  point.add({.name = "point", .channels = {ChannelKind::TranslationX}});
  for (const Weighting weighting : kWeightingsWithoutMesh)
    for (const Skeleton& skeleton : {test::small_skeleton(), point}) {
      const auto [points, weights] = measured_points(skeleton, weighting);
      EXPECT_EQ(std::ssize(points), weights.size());
      EXPECT_NEAR(weights.sum(), 1, 1e-12) << name(weighting);
    }
}

TEST(MeasuredPoints, OnTheSurfaceHaveTheMomentsOfACylinder) {
  const Skeleton skeleton = test::small_skeleton();
  const std::vector<BodyLimb> limbs = body_limbs(skeleton);
  const auto [points, weights] = measured_points(skeleton, Weighting::Surface);
  ASSERT_EQ(points.size(), 4 * limbs.size());
  for (std::size_t l = 0; l < limbs.size(); ++l) {
    const BodyLimb& limb = limbs[l];
    const double length = limb.axis_in_joint.norm();
    const Eigen::Vector3d along = limb.axis_in_joint / length;
    const Eigen::Vector3d middle = limb.axis_in_joint / 2;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    for (std::size_t p = 4 * l; p < 4 * l + 4; ++p) {
      const Eigen::Vector3d off = points[p].in_joint - middle;
      mean += off / 4;
      square += off * off.transpose() / 4;
      EXPECT_NEAR(weights(static_cast<Eigen::Index>(p)), limb.share / 4, 1e-12);
    }
    const Eigen::Matrix3d expected =
        length * length / 12 * along * along.transpose() +
        limb.radius * limb.radius / 2 * (Eigen::Matrix3d::Identity() - along * along.transpose());
    EXPECT_LT(mean.norm(), 1e-9);
    EXPECT_TRUE(square.isApprox(expected, 1e-9));
  }
}

TEST(MeasuredPoints, OnTheShellMoveWithEveryTurnOfTheirJoint) {
  const Motion motion = test::smooth_motion(2);
  const auto [points, weights] = measured_points(motion.skeleton, Weighting::Shell);
  const Eigen::MatrixXd before = point_tracks(motion.skeleton, points, motion.clip);
  for (int c = 3; c < motion.skeleton.channel_count(); ++c) {
    Clip turned = motion.clip;
    turned.channels.col(c).array() += 0.1;
    const Eigen::Index first = Eigen::Index{9} * motion.skeleton.channel_joint(c);
    const Eigen::MatrixXd moved =
        (point_tracks(motion.skeleton, points, turned) - before).middleCols(first, 9);
    // Two of the three points 3 cm away turn by a tenth, as if the third axis were the axis of
    // rotation.
    EXPECT_NEAR(moved.row(0).norm(), 2 * 3 * std::sin(0.05) * std::sqrt(2), 1e-9);
  }
}

TEST(BodyTracks, TellWhereAnyPointOfAJointIs) {
  const Motion motion = test::smooth_motion(20);
  const Clip other = test::smooth_motion(20, 3).clip;
  const Skeleton& skeleton = motion.skeleton;
  const Eigen::MatrixXd a = body_tracks(skeleton, motion.clip);
  const Eigen::MatrixXd b = body_tracks(skeleton, other);
  JointErrors errors(skeleton, a, b);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Landmark point{j, {4, -7, 11}, "anywhere"};
    const Eigen::VectorXd expected =
        (point_tracks(skeleton, {point}, other) - point_tracks(skeleton, {point}, motion.clip))
            .rowwise()
            .squaredNorm();
    Eigen::VectorXd squares(expected.size());
    JointErrors::find_squares(errors.of(j), point.in_joint, squares);
    EXPECT_TRUE(squares.isApprox(expected, 1e-9));
  }
}

}  // namespace
}  // namespace mocapress
