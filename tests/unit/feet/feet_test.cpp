// SPDX-License-Identifier: MIT
#include "core/feet/feet.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace mocapress::feet_test {
namespace {

struct Named {
  const char* name;
  int parent;
  Eigen::Vector3d offset;  // cm
};

Skeleton skeleton_of(const std::vector<Named>& joints) {
  using enum ChannelKind;
  Skeleton skeleton;
  for (const Named& joint : joints)
    skeleton.add({.name = joint.name,
                  .parent = joint.parent,
                  .offset = joint.offset,
                  .channels = {RotationZ, RotationY, RotationX}});
  return skeleton;
}

/// Two legs, a spine and two arms. `leg` names the left leg's joints; the right leg's names have
/// `right` for every `left`.
Skeleton person(const std::vector<std::string>& leg, const std::string& left,
                const std::string& right) {
  const std::vector<Eigen::Vector3d> leg_offsets = {
      {9, -5, 0}, {0, -42, 0}, {0, -41, 0}, {0, -7, 13}};
  std::vector<std::string> names = {"Hips", "Spine", "Head"};
  std::vector<Named> joints = {
      {"Hips", -1, {0, 95, 0}}, {"Spine", 0, {0, 30, 0}}, {"Head", 1, {0, 35, 0}}};
  std::vector<std::string> storage;
  storage.reserve(32);
  for (const bool is_left : {true, false}) {
    int parent = 0;
    for (std::size_t j = 0; j < leg.size(); ++j) {
      std::string name = leg[j];
      if (!is_left)
        if (const auto at = name.find(left); at != std::string::npos)
          name.replace(at, left.size(), right);
      storage.push_back(name);
      Eigen::Vector3d offset = leg_offsets[j];
      if (!is_left) offset.x() = -offset.x();
      joints.push_back({storage.back().c_str(), parent, offset});
      parent = static_cast<int>(joints.size()) - 1;
    }
    joints.push_back({is_left ? "armL" : "armR", 1, {is_left ? 18.0 : -18.0, 20, 0}});
    joints.push_back({is_left ? "elbowL" : "elbowR",
                      static_cast<int>(joints.size()) - 1,
                      {is_left ? 30.0 : -30.0, 0, 0}});
    joints.push_back({is_left ? "handL" : "handR",
                      static_cast<int>(joints.size()) - 1,
                      {is_left ? 26.0 : -26.0, 0, 0}});
  }
  return skeleton_of(joints);
}

TEST(FindFeet, KnowsTheUsualSpellings) {
  struct Case {
    std::vector<std::string> leg;
    std::string left, right, ball;
  };
  const std::vector<Case> cases = {
      {{"lfemur", "ltibia", "lfoot", "ltoes"}, "l", "r", "ltoes"},  // CMU
      {{"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase"}, "Left", "Right", "LeftToeBase"},
      {{"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"}, "Left", "Right", "LeftToe"},  // LAFAN1
      {{"mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot", "mixamorig:LeftToeBase"},
       "Left",
       "Right",
       "mixamorig:LeftToeBase"},
      {{"upperleg.L", "lowerleg.L", "foot.L", "toe1-1.L"}, ".L", ".R", "toe1-1.L"},  // makehuman
      {{"Thigh_L", "Calf_L", "Foot_L", "Toe_L"}, "_L", "_R", "Toe_L"},
      {{"LeftHip", "LeftKnee", "LeftAnkle"}, "Left", "Right", "LeftAnkle"},
  };
  for (const Case& one : cases) {
    const Skeleton skeleton = person(one.leg, one.left, one.right);
    const std::vector<Effector> feet = find_feet(skeleton);
    ASSERT_EQ(feet.size(), 2u) << one.ball;
    EXPECT_EQ(skeleton.joint(feet[0].joint).name, one.ball);
    // The chain is the leg from the hip down to above the effector.
    EXPECT_EQ(feet[0].chain.size(), one.leg.size() - 1);
    EXPECT_EQ(skeleton.joint(feet[0].chain.front()).name, one.leg.front());
  }
}

TEST(FindFeet, TakesTheSameJointOfBothFeetInWhateverOrderTheirChildrenAre) {
  const Skeleton skeleton = skeleton_of({{"Hip", -1, {0, 95, 0}},
                                         {"L_Thigh", 0, {9, -5, 0}},
                                         {"L_Calf", 1, {0, -42, 0}},
                                         {"L_Foot", 2, {0, -41, 0}},
                                         {"L_ToeBaseShareBone", 3, {0, -7, 13}},
                                         {"L_ToeBase", 3, {0, -7, 13}},
                                         {"R_Thigh", 0, {-9, -5, 0}},
                                         {"R_Calf", 6, {0, -42, 0}},
                                         {"R_Foot", 7, {0, -41, 0}},
                                         {"R_ToeBase", 8, {0, -7, 13}},
                                         {"R_ToeBaseShareBone", 8, {0, -7, 13}}});
  const std::vector<Effector> feet = find_feet(skeleton);
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_EQ(skeleton.joint(feet[0].joint).name, "L_ToeBase");
  EXPECT_EQ(skeleton.joint(feet[1].joint).name, "R_ToeBase");
}

TEST(FindFeet, FallsBackToTheLowestLimbs) {
  const Skeleton skeleton = person({"a1L", "a2L", "a3L", "a4L"}, "L", "R");
  const std::vector<Effector> feet = find_feet(skeleton);
  ASSERT_EQ(feet.size(), 2u);
  EXPECT_EQ(skeleton.joint(feet[0].joint).name, "a4L");
  EXPECT_EQ(skeleton.joint(feet[1].joint).name, "a4R");
}

TEST(FindFeet, FindsNoneWithoutLegs) {
  EXPECT_TRUE(find_feet(skeleton_of({{"base", -1, {0, 0, 0}}, {"lid", 0, {0, 10, 0}}})).empty());
}

TEST(FindFeet, LeavesOutAFootThatNothingTurns) {
  Skeleton skeleton;
  skeleton.add({.name = "Hips", .parent = -1, .channels = {ChannelKind::TranslationX}});
  skeleton.add({.name = "LeftFoot", .parent = 0, .offset = Eigen::Vector3d(0, -80, 0)});
  EXPECT_TRUE(find_feet(skeleton).empty());
}

TEST(EffectorAt, StopsWhereTheLimbLeavesTheTrunk) {
  const Skeleton skeleton =
      person({"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"}, "Left", "Right");
  const Effector hand = effector_at(skeleton, skeleton.find("handL"));
  ASSERT_EQ(hand.chain.size(), 2u);
  EXPECT_EQ(skeleton.joint(hand.chain[0]).name, "armL");
}

TEST(EffectorAt, RefusesAJointThatNothingCanMove) {
  const Skeleton skeleton =
      person({"LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe"}, "Left", "Right");
  EXPECT_THROW(effector_at(skeleton, 0), Error);
}

}  // namespace
}  // namespace mocapress::feet_test
