// SPDX-License-Identifier: MIT
#include "core/codec/encode/named_importance.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/motion/body_part.h"
#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

const Skeleton& skeleton() {
  static const Motion walk = samples::walk_clip();
  return walk.skeleton;
}

std::string joint_name(BodyPart part, std::size_t index) {
  return skeleton().joint(joints_of(skeleton(), part).at(index)).name;
}

TEST(NamedImportance, ComesBackByTheSameNames) {
  const std::string hand = joint_name(BodyPart::Hands, 0);
  NamedImportance mixed{{{"feet", 2}, {hand, 9}}, 1};
  mixed.set(joint_name(BodyPart::Feet, 0), 7);
  for (const NamedImportance& wish :
       {NamedImportance{}, NamedImportance{{{"feet", 4}}, 20},
        NamedImportance{{{"feet", 4}, {"head", 0.5}, {"root", 3}}, 0}, mixed})
    EXPECT_EQ(named(importance_for(wish, skeleton()), skeleton()), wish);
}

TEST(NamedImportance, AJointsOwnGoesBeforeItsParts) {
  const std::string foot = joint_name(BodyPart::Feet, 0);
  const Importance importance = importance_for({{{"feet", 4}, {foot, 2}}}, skeleton());
  const std::vector<int> feet = joints_of(skeleton(), BodyPart::Feet);
  EXPECT_EQ(importance.joints.at(static_cast<std::size_t>(feet[0])), 2);
  EXPECT_EQ(importance.joints.at(static_cast<std::size_t>(feet[1])), 4);
}

TEST(NamedImportance, AJointWithTheNameOfItsPartKeepsItsFactor) {
  const int head = skeleton().find("head");
  const std::vector<int> part = joints_of(skeleton(), BodyPart::Head);
  ASSERT_GE(head, 0);
  ASSERT_GT(part.size(), 2u);
  for (const double others : {1.0, 2.0}) {
    Importance importance{
        .joints = std::vector<double>(static_cast<std::size_t>(skeleton().joint_count()), 1.0)};
    for (const int joint : part) importance.joints[static_cast<std::size_t>(joint)] = others;
    importance.joints[static_cast<std::size_t>(head)] = 5;
    EXPECT_EQ(importance_for(named(importance, skeleton()), skeleton()).joints, importance.joints);
  }
}

TEST(NamedImportance, OfOneAlikeIsNone) {
  EXPECT_TRUE(importance_for({{{"feet", 1}, {"root", 1}}}, skeleton()).is_even());
}

TEST(NamedImportance, APartThatIsLackingIsLeftOutAJointIsRefused) {
  Skeleton bare;
  bare.add({.name = "root"});
  EXPECT_TRUE(importance_for({{{"fingers", 4}}}, bare).is_even());
  EXPECT_THROW(importance_for({{{"feets", 4}}}, bare), Error);
}

}  // namespace
}  // namespace mocapress
