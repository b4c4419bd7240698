// SPDX-License-Identifier: MIT
#include "core/motion/pose_block.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

/// Joints with all channels in several orders, and joints without any.
Skeleton varied_skeleton() {
  using enum ChannelKind;
  Skeleton skeleton;
  const int root = skeleton.add(
      {.name = "root",
       .offset = {1, 2, 3},
       .channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationY, RotationX}});
  const int chest = skeleton.add(
      {.name = "chest", .parent = root, .offset = {0, 30, 1}, .channels = {RotationX, RotationZ}});
  const int fixed = skeleton.add({.name = "fixed", .parent = chest, .offset = {5, 0, 0}});
  skeleton.add({.name = "hand",
                .parent = fixed,
                .offset = {20, 0, 0},
                .channels = {TranslationY, RotationY, RotationX, RotationZ}});
  return skeleton;
}

void expect_poses_of_single_frames(double most_radians) {
  const Skeleton skeleton = varied_skeleton();
  constexpr int kFrames = 150;  // the last block is not full
  Random random(3);
  Eigen::MatrixXd channels(kFrames, skeleton.channel_count());
  for (double& value : channels.reshaped()) value = most_radians * (2 * random.unit() - 1);
  Eigen::VectorXi visited = Eigen::VectorXi::Zero(kFrames);
  visit_poses(skeleton, channels, [&](const PoseBlock& poses, int first, int frames) {
    Pose pose;
    for (int t = 0; t < frames; ++t) {
      ++visited(first + t);
      compute_pose(skeleton, channels.row(first + t), pose);
      for (int j = 0; j < skeleton.joint_count(); ++j) {
        const Eigen::Vector3d in_joint(1, -2, 4);
        const double digits = 1e-12 * (1 + most_radians);
        const Eigen::Vector3d place = poses.place(j, in_joint).row(t).transpose();
        EXPECT_LT((place - pose.to_world(j, in_joint)).norm(), digits);
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3d found = poses.axis(j, axis).row(t).transpose();
          EXPECT_LT((found - pose.world_from_joint[static_cast<std::size_t>(j)].col(axis)).norm(),
                    digits);
        }
      }
    }
  });
  EXPECT_TRUE((visited.array() == 1).all());
}

TEST(PoseBlock, HasThePosesOfSingleFrames) {
  expect_poses_of_single_frames(4);
}

TEST(PoseBlock, TurnsAsFarAsAsked) {
  expect_poses_of_single_frames(5e3);
  expect_poses_of_single_frames(1e6);
}

}  // namespace
}  // namespace mocapress
