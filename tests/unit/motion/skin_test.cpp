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
  // The halfway vertex lies between 2 cm beyond the elbow straight on and 2 cm around the corner.
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

/// A BVH skeleton has the world's axes at rest; in this one the arm hangs down.
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

/// A mesh on the upper arm and a smaller one on the hand.
Skin sleeve_and_glove() {
  Skin skin = sleeve();
  for (Skin::Vertex& vertex : skin.vertices) vertex.carried_by = {{0}, {1}};
  skin.vertices[2].in_bind.z() = 12;
  for (const Eigen::Vector3f& place :
       {Eigen::Vector3f(55, 0, 0), Eigen::Vector3f(58, 0, 0), Eigen::Vector3f(55, 3, 0)})
    skin.vertices.push_back({place, {0, 0, 1}, kPlainSkin, {{2}, {1}}});
  skin.triangles.push_back({3, 4, 5});
  return skin;
}

/// As eyes, twist bones and fingers that a clip was recorded without.
TEST(Skin, StaysAsItWasBoundWhereTheClipLacksAJoint) {
  Skeleton without_wrist;
  const Skeleton whole = arm();
  without_wrist.add(whole.joint(0));
  without_wrist.add(whole.joint(1));
  Skin skin = sleeve_and_glove();
  const Skin bound = bound_to(skin, whole, without_wrist);
  EXPECT_THAT(missing_joints(skin, whole, without_wrist), ElementsAre("wrist"));
  const std::vector<Vector3d> places =
      skinned_positions(bound, pose_of(without_wrist, 0, std::numbers::pi / 2));
  EXPECT_LT((places[3] - Vector3d(30, 25, 0)).norm(), kPlace);
  EXPECT_LT((places[5] - Vector3d(27, 25, 0)).norm(), kPlace);
}

TEST(Skin, IsNotBoundWhereMostOfItWouldHangOnMissingJoints) {
  Skeleton only_wrist;
  Joint wrist;
  wrist.name = "wrist";
  only_wrist.add(wrist);
  Skeleton stranger;
  Joint hips;
  hips.name = "hips";
  stranger.add(hips);
  for (const Skeleton& other : {only_wrist, stranger}) {
    try {
      bound_to(sleeve_and_glove(), arm(), other);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("no joint shoulder, nor "));
    }
  }
}

}  // namespace
}  // namespace mocapress
