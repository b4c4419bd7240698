// SPDX-License-Identifier: MIT
#include "core/motion/body.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "resources/samples/generator/human_skeleton.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using enum ChannelKind;

double share_of(const Skeleton& skeleton, BodyRegion region) {
  const std::vector<BodyRegion> regions = body_regions(skeleton);
  double share = 0;
  for (const BodyLimb& limb : body_limbs(skeleton))
    if (regions[static_cast<std::size_t>(limb.joint)] == region) share += limb.share;
  return share;
}

const BodyLimb& limb_of(const std::vector<BodyLimb>& limbs, int joint) {
  return *std::find_if(limbs.begin(), limbs.end(),
                       [&](const BodyLimb& limb) { return limb.joint == joint; });
}

/// A skeleton as game clips have it: a root on the floor, six channels on every joint, no end
/// sites.
Skeleton game_skeleton() {
  Skeleton skeleton;
  const auto add = [&](const std::string& name, const std::string& parent,
                       const Eigen::Vector3d& offset) {
    skeleton.add(
        {.name = name,
         .parent = skeleton.find(parent),
         .offset = offset,
         .channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationX, RotationY}});
  };
  add("root", "", {0, 0, 0});
  add("Hips", "root", {0, 92, 0});
  add("Spine", "Hips", {0, 12, 0});
  add("Chest", "Spine", {0, 25, 0});
  add("Neck", "Chest", {0, 20, 0});
  add("Head", "Neck", {0, 10, 0});
  for (const auto& [side, x] : {std::pair("Left", 1.0), {"Right", -1.0}}) {
    const std::string s = side;
    add(s + "Shoulder", "Chest", {6 * x, 16, 0});
    add(s + "Arm", s + "Shoulder", {12 * x, 0, 0});
    add(s + "ForeArm", s + "Arm", {28 * x, 0, 0});
    add(s + "Hand", s + "ForeArm", {25 * x, 0, 0});
    add(s + "UpLeg", "Hips", {9 * x, -4, 0});
    add(s + "Leg", s + "UpLeg", {0, -42, 0});
    add(s + "Foot", s + "Leg", {0, -42, 0});
    add(s + "Toe", s + "Foot", {0, -6, 13});
  }
  return skeleton;
}

class BodyOf : public testing::TestWithParam<const char*> {
 protected:
  const Skeleton skeleton_ =
      GetParam() == std::string("sample") ? samples::human_skeleton() : game_skeleton();
};

INSTANTIATE_TEST_SUITE_P(Skeletons, BodyOf, testing::Values("sample", "game"));

TEST_P(BodyOf, HasTheSkinWhereLundAndBrowderHaveIt) {
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Head), 0.07, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Hand), 0.05, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Forearm), 0.06, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Foot), 0.07, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::LowerLeg), 0.14, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Thigh), 0.19, 1e-9);
  EXPECT_NEAR(share_of(skeleton_, BodyRegion::Trunk), 0.32, 1e-9);
}

TEST_P(BodyOf, IsAsThickAsPeopleAre) {
  const std::vector<BodyRegion> regions = body_regions(skeleton_);
  for (const BodyLimb& limb : body_limbs(skeleton_)) {
    const BodyRegion region = regions[static_cast<std::size_t>(limb.joint)];
    const bool is_trunk = region == BodyRegion::Trunk;
    EXPECT_GT(limb.radius, 1.5) << skeleton_.joint(limb.joint).name;
    EXPECT_LT(limb.radius, is_trunk ? 18 : 10) << skeleton_.joint(limb.joint).name;
  }
}

TEST(Body, HasTheStatureThatItsLegsTell) {
  EXPECT_NEAR(stature(samples::human_skeleton()).value_or(0), samples::kStature, 2);
  EXPECT_NEAR(stature(game_skeleton()).value_or(0), 2 * 42 / 0.491, 1e-9);
  EXPECT_FALSE(stature(test::small_skeleton()).has_value());  // arms without legs
}

TEST(Body, SharesSumToOne) {
  for (const Skeleton& skeleton :
       {samples::human_skeleton(), game_skeleton(), test::small_skeleton()}) {
    const std::vector<BodyLimb> limbs = body_limbs(skeleton);
    EXPECT_NEAR(std::accumulate(limbs.begin(), limbs.end(), 0.0,
                                [](double sum, const BodyLimb& l) { return sum + l.share; }),
                1, 1e-12);
  }
}

TEST(Body, JointsWithoutABoneExtendTheBoneBefore) {
  const Skeleton skeleton = game_skeleton();
  const std::vector<BodyLimb> limbs = body_limbs(skeleton);
  const BodyLimb& head = limb_of(limbs, skeleton.find("Head"));
  EXPECT_TRUE(head.axis_in_joint.isApprox(Eigen::Vector3d(0, 10, 0)));
  const BodyLimb& hand = limb_of(limbs, skeleton.find("LeftHand"));
  EXPECT_GT(hand.axis_in_joint.x(), 10);
  EXPECT_LT(hand.axis_in_joint.x(), 25);  // shorter than the forearm
}

TEST(Body, BetweenTheFloorAndHipsThatMoveThereIsNone) {
  const Skeleton skeleton = game_skeleton();
  for (const BodyLimb& limb : body_limbs(skeleton)) EXPECT_NE(limb.joint, skeleton.find("root"));
}

TEST(Body, BeginsAtTheJointThatMovesAwayFromARootOnTheFloor) {
  EXPECT_EQ(body_root(game_skeleton()), 1);
  EXPECT_EQ(body_root(samples::human_skeleton()), 0);
  EXPECT_EQ(body_root(Skeleton()), 0);
}

TEST(Body, AThingHasTheSameSkinForEveryCentimetre) {
  const Skeleton skeleton = test::small_skeleton();  // arms without legs
  EXPECT_TRUE(body_regions(skeleton).empty());
  const std::vector<BodyLimb> limbs = body_limbs(skeleton);
  for (const BodyLimb& limb : limbs) {
    EXPECT_NEAR(limb.share / limb.axis_in_joint.norm(),
                limbs[0].share / limbs[0].axis_in_joint.norm(), 1e-12);
    EXPECT_NEAR(limb.radius, limbs[0].radius, 1e-12);
  }
}

TEST(Body, HelpersOfTheSameNamesAtTheRootAreNoLimbs) {
  Skeleton skeleton = game_skeleton();
  for (const char* name : {"ik_foot_l", "ik_foot_r", "ik_hand_l"})
    skeleton.add({.name = name, .parent = 0, .offset = {1, 0, 0}, .channels = {RotationX}});
  EXPECT_FALSE(body_regions(skeleton).empty());
}

TEST(Body, SeesEveryJointThatTurnsThoughAllBelowItSlides) {
  Skeleton skeleton;
  skeleton.add({.name = "base", .channels = {RotationX}});
  skeleton.add({.name = "bend", .parent = 0, .offset = {0, 100, 0}, .channels = {RotationX}});
  skeleton.add(
      {.name = "tip", .parent = 1, .offset = {0, 100, 0}, .channels = {TranslationY, RotationX}});
  std::set<int> seen;
  double shares = 0;
  for (const BodyLimb& limb : body_limbs(skeleton)) {
    seen.insert(limb.joint);
    shares += limb.share;
    EXPECT_GT(limb.radius, 0);
  }
  EXPECT_EQ(seen, (std::set<int>{0, 2}));  // bend also turns what tip turns
  EXPECT_NEAR(shares, 1, 1e-12);
}

TEST(Body, APointHasNoBody) {
  Skeleton point;
  point.add({.name = "point", .channels = {TranslationX}});
  EXPECT_TRUE(body_limbs(point).empty());
}

}  // namespace
}  // namespace mocapress
