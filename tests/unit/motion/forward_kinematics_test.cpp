// SPDX-License-Identifier: MIT
#include "core/motion/forward_kinematics.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/test_motion.h"

namespace mocapress::forward_kinematics_test {
namespace {

using enum ChannelKind;

Eigen::RowVectorXd random_values(const Joint& joint, double size, Random& random) {
  Eigen::RowVectorXd values(std::ssize(joint.channels));
  for (double& value : values) value = size * (2 * random.unit() - 1);
  return values;
}

TEST(JointRotation, AnglesOfEveryOrderOfThreeAxesGiveTheRotationBack) {
  const std::vector<std::vector<ChannelKind>> orders = {
      {RotationX, RotationY, RotationZ}, {RotationX, RotationZ, RotationY},
      {RotationY, RotationX, RotationZ}, {RotationY, RotationZ, RotationX},
      {RotationZ, RotationX, RotationY}, {RotationZ, RotationY, RotationX}};
  Random random(1);
  for (const auto& order : orders)
    for (int trial = 0; trial < 50; ++trial) {
      const Joint joint{.channels = order};
      const Eigen::Matrix3d rotation = joint_rotation(joint, random_values(joint, 3, random));
      Eigen::RowVectorXd values = random_values(joint, 3, random);
      turn_joint(joint, rotation, values);
      EXPECT_LT((joint_rotation(joint, values) - rotation).norm(), 1e-12);
    }
}

TEST(JointRotation, OneAndTwoAxesGiveTheirOwnRotationsBack) {
  Random random(2);
  for (const auto& channels : {std::vector{RotationY}, std::vector{RotationZ, RotationX},
                               std::vector{TranslationX, RotationY, RotationX}})
    for (int trial = 0; trial < 50; ++trial) {
      const Joint joint{.channels = channels};
      const Eigen::RowVectorXd truth = random_values(joint, 1.5, random);
      Eigen::RowVectorXd values = truth + random_values(joint, 0.1, random);
      const double beside = values(0);
      turn_joint(joint, joint_rotation(joint, truth), values);
      EXPECT_LT((joint_rotation(joint, values) - joint_rotation(joint, truth)).norm(), 1e-8);
      if (!is_rotation(channels[0])) {
        EXPECT_EQ(values(0), beside) << "no translation changes";
      }
    }
}

TEST(JointRotation, TwoAxesComeAsNearAsAnySmallChangeOfThem) {
  Random random(3);
  const Joint free{.channels = {RotationX, RotationY, RotationZ}};
  const Joint joint{.channels = {RotationZ, RotationX}};
  for (int trial = 0; trial < 30; ++trial) {
    const Eigen::Matrix3d rotation = joint_rotation(free, random_values(free, 0.6, random));
    Eigen::RowVectorXd values = Eigen::RowVector2d::Zero();
    turn_joint(joint, rotation, values);
    const double nearest = (joint_rotation(joint, values) - rotation).norm();
    for (int c = 0; c < 2; ++c)
      for (const double change : {-1e-3, 1e-3}) {
        Eigen::RowVectorXd other = values;
        other(c) += change;
        EXPECT_GT((joint_rotation(joint, other) - rotation).norm(), nearest);
      }
  }
}

TEST(JointRotation, AnglesGoOnFromTheFrameBeforeWithoutTurns) {
  const Joint joint{.channels = {RotationZ, RotationY, RotationX}};
  Eigen::RowVectorXd values = Eigen::RowVector3d::Zero();
  for (int t = 1; t < 400; ++t) {
    const Eigen::RowVectorXd truth =
        Eigen::RowVector3d(0.05 * t, 0.8 * std::sin(0.03 * t), -0.04 * t);
    turn_joint(joint, joint_rotation(joint, truth), values);
    EXPECT_LT((values - truth).norm(), 1e-9) << t;
  }
}

TEST(JointRotation, KnowsWhichJointsTurn) {
  EXPECT_TRUE(turns({.channels = {TranslationX, RotationZ}}));
  EXPECT_FALSE(turns({.channels = {TranslationX}}));
  EXPECT_FALSE(turns({}));
}

constexpr double kTolerance = 1e-12;
constexpr double kRightAngle = std::numbers::pi / 2;

/// Two joints in a row: the first has the channels, the second sits at `offset` from it.
Skeleton two_joints(std::vector<ChannelKind> channels, const Eigen::Vector3d& offset) {
  Skeleton skeleton;
  skeleton.add({.name = "a", .channels = std::move(channels)});
  skeleton.add({.name = "b", .parent = 0, .offset = offset});
  return skeleton;
}

TEST(ForwardKinematics, MultipliesRotationsInChannelOrderForAllSixOrders) {
  std::array<int, 3> order = {0, 1, 2};
  do {
    std::vector<ChannelKind> channels;
    Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
    Eigen::RowVectorXd frame(3);
    for (std::size_t i = 0; i < 3; ++i) {
      channels.push_back(rotation_about(order[i]));
      frame(static_cast<int>(i)) = 0.3 + 0.5 * static_cast<double>(i);
      Eigen::Vector3d axis = Eigen::Vector3d::Zero();
      axis(order[i]) = frame(static_cast<int>(i));
      // The exponential of the cross-product matrix, an independent way to the same rotation.
      Eigen::Matrix3d generator;
      generator << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
      Eigen::Matrix3d term = Eigen::Matrix3d::Identity();
      Eigen::Matrix3d rotation = term;
      for (int k = 1; k < 30; ++k) {
        term = term * generator / k;
        rotation += term;
      }
      expected = expected * rotation;
    }
    const Eigen::Vector3d offset(1, 2, 3);
    Pose pose;
    compute_pose(two_joints(channels, offset), frame, pose);
    EXPECT_TRUE(pose.origin[1].isApprox(expected * offset, kTolerance));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ForwardKinematics, TurnsARightHandedQuarter) {
  // A quarter turn about y takes z to x.
  Pose pose;
  Eigen::RowVectorXd frame(1);
  frame << kRightAngle;
  compute_pose(two_joints({ChannelKind::RotationY}, {0, 0, 2}), frame, pose);
  EXPECT_TRUE(pose.origin[1].isApprox(Eigen::Vector3d(2, 0, 0), kTolerance));
}

TEST(ForwardKinematics, TurnsAboutTheJointsOwnAxes) {
  // With axes turned so that their x is the joint's y, a rotation about x turns about y.
  Skeleton skeleton;
  skeleton.add({.name = "a",
                .joint_from_axes = axis_rotation(2, kRightAngle),
                .channels = {ChannelKind::RotationX}});
  skeleton.add({.name = "b", .parent = 0, .offset = {0, 0, 2}});
  Pose pose;
  Eigen::RowVectorXd frame(1);
  frame << kRightAngle;
  compute_pose(skeleton, frame, pose);
  EXPECT_TRUE(pose.origin[1].isApprox(Eigen::Vector3d(2, 0, 0), kTolerance));
}

TEST(ForwardKinematics, AddsTranslationToTheOffsetInTheParentsFrame) {
  Skeleton skeleton;
  skeleton.add({.name = "a", .channels = {ChannelKind::RotationZ}});
  skeleton.add(
      {.name = "b", .parent = 0, .offset = {1, 0, 0}, .channels = {ChannelKind::TranslationX}});
  Pose pose;
  Eigen::RowVectorXd frame(2);
  frame << kRightAngle, 4;
  compute_pose(skeleton, frame, pose);
  EXPECT_TRUE(pose.origin[1].isApprox(Eigen::Vector3d(0, 5, 0), kTolerance));
}

TEST(ForwardKinematics, KeepsEveryBoneLength) {
  const Motion motion = test::smooth_motion(40);
  Pose pose;
  for (int t = 0; t < motion.clip.frames(); ++t) {
    compute_pose(motion.skeleton, motion.clip.channels.row(t), pose);
    for (int j = 1; j < motion.skeleton.joint_count(); ++j) {
      const Joint& joint = motion.skeleton.joint(j);
      const auto parent = static_cast<std::size_t>(joint.parent);
      EXPECT_NEAR((pose.origin[static_cast<std::size_t>(j)] - pose.origin[parent]).norm(),
                  joint.offset.norm(), 1e-9);
    }
  }
}

TEST(ForwardKinematics, RestPoseHasFramesParallelToTheWorld) {
  const Pose pose = rest_pose(test::small_skeleton());
  for (const Eigen::Matrix3d& rotation : pose.world_from_joint)
    EXPECT_TRUE(rotation.isIdentity(kTolerance));
}

}  // namespace
}  // namespace mocapress::forward_kinematics_test
