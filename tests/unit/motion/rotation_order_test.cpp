// SPDX-License-Identifier: MIT
#include "core/motion/rotation_order.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

RotationOrders all_alike(const Skeleton& skeleton, int order) {
  return RotationOrders(static_cast<std::size_t>(skeleton.joint_count()),
                        static_cast<RotationOrder>(order));
}

TEST(RotationOrder, EveryOneMovesTheBodyAlike) {
  const Motion motion = test::smooth_motion(120);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  for (int order = 0; order < kRotationOrders; ++order) {
    const Motion other = with_orders(motion, all_alike(motion.skeleton, order));
    EXPECT_TRUE(landmark_tracks(other.skeleton, other.clip).isApprox(tracks, 1e-12)) << order;
  }
}

TEST(RotationOrder, OnlyChannelsOfJointsThatTurnFreelyChange) {
  const Motion motion = test::smooth_motion(5);
  int changed = 0;
  for (int order = 0; order < kRotationOrders; ++order) {
    const Skeleton other = with_orders(motion.skeleton, all_alike(motion.skeleton, order));
    for (int j = 0; j < other.joint_count(); ++j) {
      const Joint& joint = other.joint(j);
      EXPECT_EQ(joint.name, motion.skeleton.joint(j).name);
      ASSERT_EQ(joint.channels.size(), motion.skeleton.joint(j).channels.size());
      if (turns_freely(joint)) {
        EXPECT_EQ(rotation_order(joint), static_cast<RotationOrder>(order));
        ++changed;
      } else {
        EXPECT_EQ(joint.channels, motion.skeleton.joint(j).channels);
      }
      for (std::size_t i = 0; i < joint.channels.size(); ++i)
        EXPECT_EQ(is_rotation(joint.channels[i]),
                  is_rotation(motion.skeleton.joint(j).channels[i]));
    }
  }
  EXPECT_GT(changed, 0);
}

TEST(RotationOrder, ThereAndBackGivesTheAnglesButForWholeTurns) {
  const Motion motion = test::smooth_motion(200);
  const Motion there = with_orders(motion, all_alike(motion.skeleton, 2));
  const Motion back = with_orders(there, rotation_orders(motion.skeleton));
  EXPECT_EQ(rotation_orders(back.skeleton), rotation_orders(motion.skeleton));
  EXPECT_TRUE(landmark_tracks(back.skeleton, back.clip)
                  .isApprox(landmark_tracks(motion.skeleton, motion.clip), 1e-12));
}

TEST(RotationOrder, AnglesBeginWithTheMiddleOneWithinARightOneAndNeverJump) {
  const Motion motion = test::smooth_motion(400);
  for (int order = 0; order < kRotationOrders; ++order) {
    const Motion other = with_orders(motion, all_alike(motion.skeleton, order));
    for (int j = 0; j < other.skeleton.joint_count(); ++j) {
      if (!turns_freely(other.skeleton.joint(j)) ||
          other.skeleton.joint(j).channels == motion.skeleton.joint(j).channels)
        continue;
      const auto angles = other.clip.channels.middleCols(
          other.skeleton.first_channel(j) +
              (is_rotation(other.skeleton.joint(j).channels[0]) ? 0 : 3),
          3);
      EXPECT_LE(std::abs(angles(0, 1)), std::numbers::pi / 2 + 1e-9);
      const auto steps = angles.bottomRows(399) - angles.topRows(399);
      EXPECT_LE(steps.cwiseAbs().maxCoeff(), std::numbers::pi + 1e-9);
    }
  }
}

TEST(RotationOrder, PartsThatBeginWithTheirAnglesAreThoseOfTheWhole) {
  const Motion motion = test::smooth_motion(300);
  const RotationOrders orders = all_alike(motion.skeleton, 2);
  const Motion whole = with_orders(motion, orders);
  const std::vector<int> firsts = {0, 100, 250};
  const std::vector<Eigen::Matrix3Xd> angles = angles_at(motion, orders, firsts);
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const Motion part{motion.skeleton,
                      {motion.clip.sample_rate_hz, motion.clip.channels.middleRows(firsts[i], 50)}};
    EXPECT_TRUE(with_orders(part, orders, angles[i])
                    .clip.channels.isApprox(whole.clip.channels.middleRows(firsts[i], 50), 1e-12));
  }
}

}  // namespace
}  // namespace mocapress
