// SPDX-License-Identifier: MIT
#include "core/formats/zyx_angles.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/random.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;   // difference of a rotation's entries
constexpr double kGimbalLoss = 1e-8;  // the same if y is within rounding of a quarter turn

Eigen::Matrix3d zyx(const Eigen::Vector3d& angles) {
  return axis_rotation(2, angles.z()) * axis_rotation(1, angles.y()) * axis_rotation(0, angles.x());
}

TEST(ZyxAngles, RebuildEveryRotation) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d angles =
        Eigen::Vector3d::NullaryExpr([&] { return (random.unit() - 0.5) * 4 * kPi; });
    const Eigen::Matrix3d rotation = zyx(angles);
    EXPECT_NEAR((zyx(zyx_angles(rotation, Eigen::Vector3d::Zero())) - rotation).norm(), 0,
                kRounding);
  }
}

TEST(ZyxAngles, ReturnTheAnglesThemselvesWhenAskedNearThem) {
  const Eigen::Vector3d angles(7.0, -2.5, 11.0);  // beyond a turn, and y beyond a quarter
  EXPECT_NEAR((zyx_angles(zyx(angles), angles.array() + 0.1) - angles).norm(), 0, kRounding);
}

TEST(ZyxAngles, RebuildRotationsInGimbalLock) {
  for (const double y : {kPi / 2, -kPi / 2, kPi / 2 - 1e-10}) {
    const Eigen::Matrix3d rotation = zyx({0.3, y, -0.8});
    EXPECT_NEAR((zyx(zyx_angles(rotation, {1, 2, 3})) - rotation).norm(), 0, kGimbalLoss);
  }
}

TEST(ZyxAngles, StayContinuousThroughASpin) {
  Eigen::Vector3d previous = Eigen::Vector3d::Zero();
  const Eigen::Matrix3d tilt = axis_rotation(0, 0.7);
  for (int t = 1; t <= 1000; ++t) {
    const Eigen::Matrix3d rotation = tilt * axis_rotation(1, t * 0.02) * tilt.transpose();
    const Eigen::Vector3d angles = zyx_angles(rotation, previous);
    EXPECT_LT((angles - previous).cwiseAbs().maxCoeff(), 0.1) << t;
    previous = angles;
  }
}

TEST(WithZyxAngles, MovesNoPoint) {
  Motion motion;
  Joint root;
  root.channels = {ChannelKind::TranslationY, ChannelKind::RotationX};
  motion.skeleton.add(root);
  Joint arm;
  arm.parent = 0;
  arm.offset = {1, 2, 3};
  arm.joint_from_axes = zyx({0.4, -1.1, 2.0});
  arm.channels = {ChannelKind::RotationY, ChannelKind::TranslationZ, ChannelKind::RotationX};
  arm.end_site = Eigen::Vector3d(10, 0, 5);
  motion.skeleton.add(arm);
  Random random(2);
  motion.clip.channels = Eigen::MatrixXd::NullaryExpr(50, 5, [&] { return random.unit() * 3; });

  const Motion turned = with_zyx_angles(
      motion, [](const Joint& joint) { return !joint.joint_from_axes.isIdentity(0); });
  EXPECT_EQ(turned.skeleton.joint(0).channels, root.channels);
  EXPECT_TRUE(turned.skeleton.joint(1).joint_from_axes.isIdentity(0));
  EXPECT_NEAR((landmark_tracks(turned.skeleton, turned.clip) -
               landmark_tracks(motion.skeleton, motion.clip))
                  .cwiseAbs()
                  .maxCoeff(),
              0, 1e-10);
}

}  // namespace
}  // namespace mocapress
