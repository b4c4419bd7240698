// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/exaggeration.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

Pose turned(double degrees, const Eigen::Vector3d& at) {
  const double angle = degrees * std::numbers::pi / 180;
  return {{Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).matrix()}, {at}};
}

TEST(Exaggeration, MultipliesDifferencesOfPositions) {
  const Eigen::MatrixXd original = Eigen::MatrixXd::Constant(2, 3, 10);
  const Eigen::MatrixXd other = Eigen::MatrixXd::Constant(2, 3, 10.5);
  EXPECT_TRUE(exaggerated(original, other, 1).isApprox(other));
  EXPECT_TRUE(exaggerated(original, other, 20).isApproxToConstant(20));
}

TEST(Exaggeration, MultipliesPlaceAndAngleOfAPose) {
  Pose pose = turned(33, {1, 2, 3});
  exaggerate(turned(30, {1, 2, 0}), 10, pose);
  const Pose expected = turned(60, {1, 2, 30});
  EXPECT_TRUE(pose.world_from_joint[0].isApprox(expected.world_from_joint[0], 1e-9));
  EXPECT_TRUE(pose.origin[0].isApprox(expected.origin[0], 1e-9));
}

TEST(Exaggeration, TurnsNoJointFurtherThanHalfATurn) {
  Pose pose = turned(20, {0, 0, 0});
  exaggerate(turned(0, {0, 0, 0}), 20, pose);
  EXPECT_TRUE(pose.world_from_joint[0].isApprox(turned(180, {}).world_from_joint[0], 1e-9));
}

TEST(Exaggeration, NeedsPosesOfBoth) {
  EXPECT_FALSE(exaggeratedPoses(
      {}, [](int, Pose&) {}, 2));
  EXPECT_FALSE(exaggeratedPoses([](int, Pose&) {}, {}, 2));
}

}  // namespace
}  // namespace mocapress
