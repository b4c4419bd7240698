// SPDX-License-Identifier: MIT
#include "core/motion/measured_points.h"

#include <gtest/gtest.h>

#include "core/motion/body.h"
#include "core/motion/body_tracks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(MeasuredPoints, WeighOneInEveryWeighting) {
  Skeleton point;
  point.add({.name = "point", .channels = {ChannelKind::TranslationX}});
  for (const Weighting weighting : kWeightings)
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
    // Two of three axes at 3 cm turn by a tenth, were the third the axis itself.
    EXPECT_NEAR(moved.row(0).norm(), 2 * 3 * std::sin(0.05) * std::sqrt(2), 1e-9);
  }
}

TEST(BodyTracks, TellWhereAnyPointOfAJointIs) {
  const Motion motion = test::smooth_motion(20);
  const Clip other = test::smooth_motion(20, 3).clip;
  const Skeleton& skeleton = motion.skeleton;
  const Eigen::MatrixXd a = body_tracks(skeleton, motion.clip);
  const Eigen::MatrixXd b = body_tracks(skeleton, other);
  const JointErrors errors(skeleton, a, b);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Landmark point{j, {4, -7, 11}, "anywhere"};
    const Eigen::VectorXd expected =
        (point_tracks(skeleton, {point}, other) - point_tracks(skeleton, {point}, motion.clip))
            .rowwise()
            .squaredNorm();
    EXPECT_TRUE(JointErrors::squared(errors.of(j), point.in_joint).isApprox(expected, 1e-9));
  }
}

}  // namespace
}  // namespace mocapress
