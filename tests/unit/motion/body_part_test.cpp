// SPDX-License-Identifier: MIT
#include "core/motion/body_part.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

Skeleton with_joints(std::initializer_list<const char*> names) {
  Skeleton skeleton;
  int parent = -1;
  for (const char* name : names) {
    skeleton.add({.name = name, .parent = parent});
    parent = 0;
  }
  return skeleton;
}

TEST(BodyPart, IsFoundInTheSpellingsOfEveryFamilyOfSkeletons) {
  const Skeleton cmu = with_joints({"root", "lfoot", "ltoes", "lwrist", "lhand", "lfingers",
                                    "lthumb", "upperneck", "head", "lfemur", "lowerback"});
  EXPECT_EQ(joints_of(cmu, BodyPart::Feet), std::vector({1, 2}));
  EXPECT_EQ(joints_of(cmu, BodyPart::Hands), std::vector({3, 4}));
  EXPECT_EQ(joints_of(cmu, BodyPart::Fingers), std::vector({5, 6}));
  EXPECT_EQ(joints_of(cmu, BodyPart::Head), std::vector({7, 8}));
  const Skeleton mixamo =
      with_joints({"mixamorig:Hips", "mixamorig:LeftFoot", "mixamorig:LeftToeBase",
                   "mixamorig:LeftHand", "mixamorig:LeftHandIndex1", "mixamorig:Head"});
  EXPECT_EQ(joints_of(mixamo, BodyPart::Feet), std::vector({1, 2}));
  EXPECT_EQ(joints_of(mixamo, BodyPart::Hands), std::vector({3}));
  EXPECT_EQ(joints_of(mixamo, BodyPart::Fingers), std::vector({4}));
  EXPECT_EQ(joints_of(mixamo, BodyPart::Head), std::vector({5}));
}

TEST(BodyPart, IsNothingWhereNoNameSaysSo) {
  const Skeleton skeleton = with_joints({"root", "spine_middle", "Chest", "LeftKnee"});
  for (const BodyPart part : kBodyParts) EXPECT_TRUE(joints_of(skeleton, part).empty());
}

}  // namespace
}  // namespace mocapress
