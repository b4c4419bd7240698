// SPDX-License-Identifier: MIT
#include "resources/samples/generator/leg_ik.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress::samples {
namespace {

double between(Random& random, double low, double high) {
  return low + (high - low) * random.unit();
}

TEST(LegIk, PutsEveryFootInReachExactlyWhereItShouldBe) {
  const Skeleton skeleton = human_skeleton();
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Side side = i % 2 ? Side::Left : Side::Right;
    Posture posture;
    posture.root = {5, between(random, 75, 92), -3};
    posture.degrees["root"] = {between(random, -5, 20), between(random, -40, 40),
                               between(random, -6, 6)};
    const Eigen::Vector3d hip =
        posture.root + world_from_root(posture) * mirrored_offset(side, kHipInRoot);
    FootState foot{};
    foot.ankle = {hip.x() + between(random, -8, 8), between(random, 7, 25),
                  hip.z() + between(random, -25, 25)};
    foot.yaw = in_radians(posture.degrees["root"].y() + between(random, -12, 12));
    foot.pitch = between(random, -0.3, 1.0);
    foot.toe_pitch = between(random, -0.3, 0.3);
    ASSERT_LT((foot.ankle - hip).norm(), leg_length(1));

    place_foot(posture, side, foot);
    Pose pose;
    compute_pose(skeleton, channels_of(skeleton, posture), pose);
    const auto joint = [&](const char* name) {
      return static_cast<std::size_t>(skeleton.find(sided(side, name)));
    };
    EXPECT_LT((pose.origin[joint("foot")] - foot.ankle).norm(), 1e-9);
    EXPECT_LT((pose.world_from_joint[joint("foot")] - foot.world_from_foot()).norm(), 1e-9);
    EXPECT_LT((pose.world_from_joint[joint("toes")] - foot.world_from_toes()).norm(), 1e-9);
    EXPECT_GE(posture.degrees[sided(side, "tibia")].x(), 0);
  }
}

TEST(LegIk, StretchesTowardsAFootOutOfReach) {
  Posture posture;
  posture.root = {0, 120, 0};
  posture.degrees["root"] = {0, 0, 0};
  place_foot(posture, Side::Left, {{kHipInRoot.x(), kAnkleHeight, 0}, 0, 0, 0});
  EXPECT_LT(posture.degrees["ltibia"].x(), 2);
  EXPECT_NEAR(posture.degrees["lfemur"].z(), 0, 1e-9);
}

}  // namespace
}  // namespace mocapress::samples
