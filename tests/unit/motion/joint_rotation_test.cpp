// SPDX-License-Identifier: MIT
#include "core/motion/joint_rotation.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace mocapress {
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

}  // namespace
}  // namespace mocapress
