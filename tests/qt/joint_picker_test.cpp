// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/orbit_camera.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

OrbitCamera camera() {
  OrbitCamera camera;
  camera.setViewSize({800, 600});
  camera.lookAt({0, 90, 0}, 100);
  return camera;
}

/// Two frames of three joints and an end site; the second is 500 cm higher. Joint 2 is in the same
/// place as joint 1.
Eigen::MatrixXd tracks() {
  Eigen::MatrixXd tracks(2, 12);
  tracks.row(0) << 0, 90, 0, 40, 90, 0, 40, 90, 0, 0, 150, 0;
  tracks.row(1) = tracks.row(0);
  for (const int y : {1, 4, 7, 10}) tracks(1, y) += 500;
  return tracks;
}

TEST(JointPicker, PicksTheJointUnderTheCursor) {
  const QPointF seen = *camera().project({0, 90, 0});
  const auto picked = pickJoint(camera(), tracks(), 0, 3, seen + QPointF(3, 4));
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->joint, 0);
  EXPECT_NEAR(picked->distance, 5, 1e-3);
}

TEST(JointPicker, PicksTheFirstOfJointsAtOnePlace) {
  const auto picked = pickJoint(camera(), tracks(), 0, 3, *camera().project({40, 90, 0}));
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->joint, 1);
}

TEST(JointPicker, PicksNothingOutOfReach) {
  const QPointF seen = *camera().project({0, 90, 0});
  EXPECT_TRUE(pickJoint(camera(), tracks(), 0, 3, seen + QPointF(0, 11.9)));
  EXPECT_FALSE(pickJoint(camera(), tracks(), 0, 3, seen + QPointF(0, 12.1)));
}

TEST(JointPicker, PicksNoEndSite) {
  EXPECT_FALSE(pickJoint(camera(), tracks(), 0, 3, *camera().project({0, 150, 0})));
}

TEST(JointPicker, LooksAtTheGivenFrame) {
  EXPECT_FALSE(pickJoint(camera(), tracks(), 1, 3, *camera().project({0, 90, 0})));
}

}  // namespace
}  // namespace mocapress
