// SPDX-License-Identifier: MIT
#include "core/motion/rig.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

Skeleton skeleton_of(const std::vector<std::pair<std::string, int>>& joints) {
  Skeleton skeleton;
  for (const auto& [name, parent] : joints) {
    Joint joint;
    joint.name = name;
    joint.parent = parent;
    skeleton.add(joint);
  }
  return skeleton;
}

TEST(Rig, IsTheSameWhateverTheOrderTheNamespaceAndTheLengths) {
  const Skeleton one = skeleton_of({{"Hips", -1}, {"Spine", 0}, {"LeftLeg", 0}});
  const Skeleton named = skeleton_of({{"a:Hips", -1}, {"a:LeftLeg", 0}, {"a:Spine", 0}});
  Skeleton other;
  for (Joint joint : named.joints()) {
    joint.offset = {0, 7, 0};
    joint.channels = {ChannelKind::RotationX};
    other.add(joint);
  }
  EXPECT_EQ(rig_of(one), rig_of(other));
}

TEST(Rig, IsAnotherWithAnotherJointOrParent) {
  const std::string rig = rig_of(skeleton_of({{"Hips", -1}, {"Spine", 0}, {"Head", 1}}));
  EXPECT_NE(rig, rig_of(skeleton_of({{"Hips", -1}, {"Spine", 0}, {"Head", 0}})));
  EXPECT_NE(rig, rig_of(skeleton_of({{"Hips", -1}, {"Spine", 0}, {"Neck", 1}})));
  EXPECT_NE(rig, rig_of(skeleton_of({{"Hips", -1}, {"Spine", 0}, {"Head", 1}, {"Eye", 2}})));
}

TEST(Rig, HasANamespaceWhereAllJointsShareIt) {
  EXPECT_EQ(shared_namespace(skeleton_of({{"mixamorig:Hips", -1}, {"mixamorig:Spine", 0}})),
            "mixamorig:");
  EXPECT_EQ(shared_namespace(skeleton_of({{"a:b:Hips", -1}, {"a:b:Spine", 0}})), "a:b:");
  EXPECT_EQ(shared_namespace(skeleton_of({{"a:Hips", -1}, {"Spine", 0}})), "");
  EXPECT_EQ(shared_namespace(skeleton_of({{"a:Hips", -1}, {"a:", 0}})), "");
  EXPECT_EQ(shared_namespace(skeleton_of({{"Hips", -1}})), "");
  EXPECT_EQ(shared_namespace({}), "");
}

}  // namespace
}  // namespace mocapress
