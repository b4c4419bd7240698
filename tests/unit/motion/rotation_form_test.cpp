// SPDX-License-Identifier: MIT
#include "core/motion/rotation_form.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// Orders 0 to 5 with the plain axes, then the same with turned axes.
constexpr int kForms = 2 * kRotationOrders;

RotationForms all_alike(const Skeleton& skeleton, int form) {
  RotationForm each{static_cast<RotationOrder>(form % kRotationOrders)};
  if (form >= kRotationOrders) {
    each.before = {3, -7, 12};
    each.after = {-16, 5, 1};
  }
  return RotationForms(static_cast<std::size_t>(skeleton.joint_count()), each);
}

TEST(RotationForm, EveryOneMovesTheBodyAlike) {
  const Motion motion = test::smooth_motion(120);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  for (int form = 0; form < kForms; ++form) {
    const Motion other = with_forms(motion, all_alike(motion.skeleton, form));
    EXPECT_TRUE(landmark_tracks(other.skeleton, other.clip).isApprox(tracks, 1e-12)) << form;
  }
}

TEST(RotationForm, OnlyChannelsOfJointsThatTurnFreelyChange) {
  const Motion motion = test::smooth_motion(5);
  int changed = 0;
  for (int form = 0; form < kForms; ++form) {
    const Skeleton other = with_forms(motion.skeleton, all_alike(motion.skeleton, form));
    for (int j = 0; j < other.joint_count(); ++j) {
      const Joint& joint = other.joint(j);
      EXPECT_EQ(joint.name, motion.skeleton.joint(j).name);
      ASSERT_EQ(joint.channels.size(), motion.skeleton.joint(j).channels.size());
      if (turns_freely(joint)) {
        EXPECT_EQ(rotation_order(joint), static_cast<RotationOrder>(form % kRotationOrders));
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

TEST(RotationForm, ThereAndBackGivesTheAnglesButForWholeTurns) {
  const Motion motion = test::smooth_motion(200);
  const Motion there = with_forms(motion, all_alike(motion.skeleton, 8));
  const Motion back = with_forms(there, rotation_forms(motion.skeleton));
  EXPECT_EQ(rotation_forms(back.skeleton), rotation_forms(motion.skeleton));
  EXPECT_TRUE(landmark_tracks(back.skeleton, back.clip)
                  .isApprox(landmark_tracks(motion.skeleton, motion.clip), 1e-12));
}

TEST(RotationForm, AnglesBeginWithTheMiddleOneWithinARightOneAndNeverJump) {
  const Motion motion = test::smooth_motion(400);
  for (int form = 0; form < kForms; ++form) {
    const Motion other = with_forms(motion, all_alike(motion.skeleton, form));
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

TEST(RotationForm, PartsThatBeginWithTheirAnglesAreThoseOfTheWhole) {
  const Motion motion = test::smooth_motion(300);
  const RotationForms forms = all_alike(motion.skeleton, 8);
  const Motion whole = with_forms(motion, forms);
  const std::vector<int> firsts = {0, 100, 250};
  const std::vector<Eigen::Matrix3Xd> angles = angles_at(motion, forms, firsts);
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const Motion part{motion.skeleton,
                      {motion.clip.sample_rate_hz, motion.clip.channels.middleRows(firsts[i], 50)}};
    EXPECT_TRUE(with_forms(part, forms, angles[i])
                    .clip.channels.isApprox(whole.clip.channels.middleRows(firsts[i], 50), 1e-12));
  }
}

TEST(RotationForm, FixedTurnsComeNearAnyRotation) {
  for (int t = 0; t < 60; ++t) {
    const Eigen::Matrix3d rotation =
        axis_rotation(0, 0.3 * t) * axis_rotation(1, 1.1 * t) * axis_rotation(2, 0.7 * t);
    const FixedTurn turn = fixed_turn_near(rotation);
    EXPECT_LT(Eigen::AngleAxisd(rotation.transpose() * rotation_of(turn)).angle(), 0.2) << t;
  }
  EXPECT_EQ(rotation_of({}), Eigen::Matrix3d::Identity());
}

TEST(RotationForm, ASourceFormHasNoFixedTurns) {
  const Motion motion = test::smooth_motion(60);
  const Motion turned = with_forms(motion, all_alike(motion.skeleton, 9));
  const Motion back = with_forms(turned, rotation_forms(motion.skeleton));
  for (const Joint& joint : back.skeleton.joints()) {
    EXPECT_EQ(joint.before, Eigen::Matrix3d::Identity());
    EXPECT_EQ(joint.after, Eigen::Matrix3d::Identity());
  }
  EXPECT_TRUE(landmark_tracks(back.skeleton, back.clip)
                  .isApprox(landmark_tracks(motion.skeleton, motion.clip), 1e-12));
}

}  // namespace
}  // namespace mocapress
