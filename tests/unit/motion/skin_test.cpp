// SPDX-License-Identifier: MIT
#include "core/motion/skin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/base/error.h"

namespace mocapress {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;

constexpr double kPlace = 1e-5;  // cm; vertices are floats

/// Upper and lower half of an arm along x: the elbow at 30 turns about z.
Skeleton arm(const std::string& prefix = {}) {
  Skeleton skeleton;
  Joint shoulder;
  shoulder.name = prefix + "shoulder";
  shoulder.channels = {ChannelKind::TranslationY};
  skeleton.add(shoulder);
  Joint elbow;
  elbow.name = prefix + "elbow";
  elbow.parent = 0;
  elbow.offset = {30, 0, 0};
  elbow.channels = {ChannelKind::RotationZ};
  skeleton.add(elbow);
  Joint wrist;
  wrist.name = prefix + "wrist";
  wrist.parent = 1;
  wrist.offset = {25, 0, 0};
  skeleton.add(wrist);
  return skeleton;
}

Affine3d at(double x) {
  return Affine3d(Eigen::Translation3d(-x, 0, 0));
}

/// A vertex on the upper arm, one halfway at the elbow, one at the wrist.
Skin sleeve() {
  Skin skin;
  skin.bones = {{0, at(0)}, {1, at(30)}, {2, at(55)}};
  const auto vertex = [](float x, BoneWeights weights) {
    return Skin::Vertex{{x, 0, 2}, {0, 0, 1}, kPlainSkin, weights};
  };
  skin.vertices = {vertex(10, {{0}, {1}}), vertex(32, {{0, 1}, {0.5F, 0.5F}}),
                   vertex(55, {{2}, {1}})};
  skin.triangles = {{0, 1, 2}};
  return skin;
}

Pose pose_of(const Skeleton& skeleton, double y, double turn) {
  Pose pose;
  compute_pose(skeleton, Eigen::RowVector2d(y, turn), pose);
  return pose;
}

void expect_places(const std::vector<Vector3d>& found, const std::vector<Vector3d>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_LT((found[i] - wanted[i]).norm(), kPlace) << i << ": " << found[i].transpose();
}

TEST(Skin, BlendsWhatItsBonesDo) {
  const Pose pose = pose_of(arm(), 7, std::numbers::pi / 2);
  // The halfway vertex: 2 cm beyond the elbow, straight on and around the corner.
  expect_places(skinned_positions(sleeve(), pose),
                {{10, 7, 2}, (Vector3d(32, 7, 2) + Vector3d(30, 9, 2)) / 2, {30, 32, 2}});
}

TEST(Skin, KeepsTheFourLargestWeights) {
  const BoneWeights weights =
      largest_weights({{9, 0.05}, {3, 0.4}, {4, 0}, {5, 0.2}, {6, 0.2}, {7, 0.1}, {8, 0.1}});
  EXPECT_THAT(weights.bones, ElementsAre(3, 5, 6, 7));
  EXPECT_THAT(weights.weights, ElementsAre(FloatEq(0.4F / 0.9F), FloatEq(0.2F / 0.9F),
                                           FloatEq(0.2F / 0.9F), FloatEq(0.1F / 0.9F)));
  EXPECT_THAT(largest_weights({}).weights, ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(largest_weights({{2, -1.0}, {1, 3.0}}).bones, ElementsAre(1, 0, 0, 0));
}

TEST(Skin, IsBoundToJointsOfTheSameNamesInAnotherOrder) {
  Skeleton other;
  Joint floor;
  floor.name = "rig:floor";
  other.add(floor);
  const Skeleton same = arm("rig:");
  for (Joint joint : same.joints()) {
    ++joint.parent;
    other.add(joint);
  }
  const Skin bound = bound_to(sleeve(), arm(), other);
  EXPECT_EQ(bound.bones[2].joint, 3);
  expect_places(skinned_positions(bound, pose_of(other, 7, 1)),
                skinned_positions(sleeve(), pose_of(arm(), 7, 1)));
}

/// A BVH's: axes as the world's at rest, where the arm hangs down.
TEST(Skin, IsBoundToJointsWithOtherAxesByTheirRestPose) {
  Skeleton other;
  const Skeleton same = arm();
  for (Joint joint : same.joints()) {
    joint.offset = {0, -joint.offset.x(), 0};
    other.add(joint);
  }
  const Skin bound = bound_to(sleeve(), arm(), other);
  expect_places(skinned_positions(bound, pose_of(other, 0, 0)),
                {{0, -10, 2}, {0, -32, 2}, {0, -55, 2}});
}

TEST(Skin, IsNotBoundToASkeletonWithoutItsJoints) {
  Skeleton other;
  Joint shoulder;
  shoulder.name = "shoulder";
  other.add(shoulder);
  try {
    bound_to(sleeve(), arm(), other);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no joint elbow, nor 1 more"));
  }
}

}  // namespace
}  // namespace mocapress
