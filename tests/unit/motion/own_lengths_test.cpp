// SPDX-License-Identifier: MIT
// A character with other proportions than the clip that it is put on.
#include "core/motion/own_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace mocapress::own_lengths_test {
namespace {

using Eigen::Vector3d;

constexpr double kPlace = 1e-4;  // cm; vertices are floats

struct Build {
  double legs = 1;
  double arms = 1;
  bool on_a_root = false;  // the hips hang on a joint on the floor
};

/// Someone who stands with the feet on the floor and the arms out.
Skeleton body(const Build& build) {
  Skeleton skeleton;
  const auto add = [&](const std::string& name, const std::string& parent, const Vector3d& offset) {
    Joint joint;
    joint.name = name;
    joint.parent = skeleton.find(parent);
    joint.offset = offset;
    if (name == "hips")
      joint.channels = {ChannelKind::TranslationX, ChannelKind::TranslationY,
                        ChannelKind::TranslationZ};
    for (const ChannelKind turn :
         {ChannelKind::RotationZ, ChannelKind::RotationX, ChannelKind::RotationY})
      joint.channels.push_back(turn);
    skeleton.add(joint);
  };
  if (build.on_a_root) add("root", "", Vector3d::Zero());
  add("hips", "root", {0, 90 * build.legs, 0});
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    add(name + "thigh", "hips", {10 * side, 0, 0});
    add(name + "shin", name + "thigh", {0, -45 * build.legs, 0});
    add(name + "foot", name + "shin", {0, -45 * build.legs, 0});
  }
  add("spine", "hips", {0, 50, 0});
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    add(name + "arm", "spine", {20 * side, 0, 0});
    add(name + "hand", name + "arm", {50 * side * build.arms, 0, 0});
  }
  return skeleton;
}

/// At each joint a triangle around the place where it was bound, carried half by the joint above.
Skin mesh_of(const Skeleton& skeleton) {
  Skin skin;
  const Pose rest = rest_pose(skeleton);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Vector3d& at = rest.origin[static_cast<std::size_t>(j)];
    skin.bones.push_back({j, Eigen::Affine3d(Eigen::Translation3d(-at))});
    const int above = std::max(skeleton.joint(j).parent, 0);
    const BoneWeights halves{{static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(above)},
                             {0.5F, 0.5F}};
    const auto first = static_cast<std::uint32_t>(skin.vertices.size());
    for (const Vector3d& corner : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 0, 1)})
      skin.vertices.push_back(
          {(at + corner).cast<float>(), {0, 1, 0}, kPlainSkin, halves, {0, 0}, -1});
    skin.triangles.push_back({first, first + 1, first + 2});
  }
  return skin;
}

class OwnLengths : public testing::Test {
 protected:
  /// `who` on the clip's joints, in a pose of the clip: the hips lowered and moved, knees bent.
  void put(const Build& who, const Build& of_clip, bool bent = true) {
    clip_ = body(of_clip);
    who_ = body(who);
    skin_ = bound_to(mesh_of(who_), who_, clip_);
    Eigen::RowVectorXd frame = Eigen::RowVectorXd::Zero(clip_.channel_count());
    const auto turn = [&](const char* joint, double radians) {
      // The second rotation is about x.
      const int last = clip_.first_channel(clip_.find(joint)) +
                       static_cast<int>(clip_.joint(clip_.find(joint)).channels.size()) - 1;
      frame[last - 1] = radians;
    };
    if (bent) {
      frame[clip_.first_channel(clip_.find("hips"))] = 30;
      frame[clip_.first_channel(clip_.find("hips")) + 1] = -90 * of_clip.legs * (1 - std::cos(0.6));
      for (const char* thigh : {"leftthigh", "rightthigh"}) turn(thigh, -0.6);
      for (const char* shin : {"leftshin", "rightshin"}) turn(shin, 1.2);
      turn("leftarm", 0.7);
    }
    compute_pose(clip_, frame, pose_);
    places_ = skinned_positions(skin_, pose_);
  }

  /// The position of the vertex that was bound at the joint.
  Vector3d at(const std::string& joint) const {
    return places_[3 * static_cast<std::size_t>(who_.find(joint))];
  }
  Vector3d in_clip(const std::string& joint) const {
    return pose_.origin[static_cast<std::size_t>(clip_.find(joint))];
  }

  Skeleton clip_, who_;
  Skin skin_;
  Pose pose_;
  std::vector<Vector3d> places_;
};

TEST_F(OwnLengths, AreTheClipsWhereTheyAgree) {
  put({}, {});
  EXPECT_TRUE(skin_.lengths.bones.empty());
  EXPECT_LT((at("leftfoot") - in_clip("leftfoot")).norm(), kPlace);
}

TEST_F(OwnLengths, AreKeptAndNothingTears) {
  put({.legs = 1.3, .arms = 0.8}, {});
  EXPECT_NEAR((at("leftshin") - at("leftthigh")).norm(), 45 * 1.3, kPlace);
  EXPECT_NEAR((at("leftfoot") - at("leftshin")).norm(), 45 * 1.3, kPlace);
  EXPECT_NEAR((at("leftthigh") - at("hips")).norm(), 10, kPlace);
  EXPECT_NEAR((at("lefthand") - at("leftarm")).norm(), 50 * 0.8, kPlace);
  // They point where the clip's do.
  EXPECT_GT((at("lefthand") - at("leftarm"))
                .normalized()
                .dot((in_clip("lefthand") - in_clip("leftarm")).normalized()),
            1 - 1e-9);
}

TEST_F(OwnLengths, LeaveTheFeetOnTheFloorAndStepsInProportion) {
  for (const double legs : {0.7, 1.3}) {
    put({.legs = legs, .arms = 1.1}, {});
    EXPECT_NEAR(skin_.lengths.scale, legs, 1e-6);
    EXPECT_NEAR(in_clip("leftfoot").y(), 0, kPlace);
    EXPECT_NEAR(at("leftfoot").y(), 0, kPlace);
    EXPECT_NEAR(at("rightfoot").y(), 0, kPlace);
    EXPECT_NEAR(at("hips").x(), 30 * legs, kPlace);
  }
}

TEST_F(OwnLengths, TakeJointsThatCarryNothingAlong) {
  Joint finger;
  finger.name = "finger";
  const Skeleton hand = body({});
  finger.parent = hand.find("lefthand");
  finger.offset = {8, 0, 0};
  Skeleton clip = hand;
  clip.add(finger);
  who_ = body({.legs = 1.3, .arms = 0.8});
  const Skin skin = bound_to(mesh_of(who_), who_, clip);
  const Pose pose = rest_pose(clip);
  const std::vector<Vector3d> own = own_origins(skin.lengths, pose);
  const auto in_own = [&](const char* joint) {
    return own[static_cast<std::size_t>(clip.find(joint))];
  };
  EXPECT_NEAR((in_own("finger") - in_own("lefthand")).norm(), 8 * skin.lengths.scale, kPlace);
}

TEST_F(OwnLengths, GrowAroundAPlaceOnTheFloor) {
  put({.legs = 1.3}, {});
  skin_.lengths.centre = {30, 0, 0};
  places_ = skinned_positions(skin_, pose_);
  EXPECT_NEAR(at("hips").x(), 30, kPlace);
  EXPECT_NEAR(at("leftfoot").y(), 0, kPlace);
}

TEST_F(OwnLengths, FollowHipsThatMoveOnARoot) {
  put({.legs = 1.3, .on_a_root = true}, {.on_a_root = true});
  EXPECT_NEAR(at("leftfoot").y(), 0, kPlace);
  EXPECT_NEAR((at("leftshin") - at("leftthigh")).norm(), 45 * 1.3, kPlace);
  put({.legs = 1.3}, {.on_a_root = true});
  EXPECT_NEAR(at("leftfoot").y(), 0, kPlace);
}

TEST_F(OwnLengths, AreKeptInAChainThatDoesNotBranch) {
  Skeleton clip, who;
  for (Skeleton* skeleton : {&clip, &who})
    for (int j = 0; j < 3; ++j) {
      Joint joint;
      joint.name = "tail" + std::to_string(j);
      joint.parent = j - 1;
      if (j > 0) joint.offset = {skeleton == &clip ? 10.0 : 25.0, 0, 0};
      joint.channels = {ChannelKind::RotationZ};
      skeleton->add(joint);
    }
  const Skin skin = bound_to(mesh_of(who), who, clip);
  Pose pose;
  compute_pose(clip, Eigen::RowVector3d(0, 1, 0), pose);
  const std::vector<Vector3d> places = skinned_positions(skin, pose);
  EXPECT_NEAR((places[3] - places[0]).norm(), 25, kPlace);
  EXPECT_NEAR((places[6] - places[3]).norm(), 25, kPlace);
}

}  // namespace
}  // namespace mocapress::own_lengths_test
