// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/importance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/motion/body_part.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::importance_test {
namespace {

const Encoder& walk() {
  static const Encoder shared(samples::walk_clip());
  return shared;
}

Encoding encoded(Method method, const Importance& importance) {
  return walk().encode({.method = method,
                        .coding = Coding::Adaptive,
                        .weighting = Weighting::BoneEnds,
                        .target = {Target::Kind::Ratio, 150},
                        .importance = importance});
}

std::vector<double> factor_of(BodyPart part, double factor) {
  const Skeleton& skeleton = walk().motion().skeleton;
  std::vector<double> joints(static_cast<std::size_t>(skeleton.joint_count()), 1.0);
  for (const int joint : joints_of(skeleton, part))
    joints[static_cast<std::size_t>(joint)] = factor;
  return joints;
}

double mean_error_of(BodyPart part, const Encoding& encoding) {
  double sum = 0;
  const auto joints = joints_of(walk().motion().skeleton, part);
  for (const int joint : joints) sum += encoding.distortion.distances.col(joint).mean();
  return sum / static_cast<double>(joints.size());
}

TEST(Importance, BringsAPartNearerAtTheSameSize) {
  for (const Method method : {Method::Annealed, Method::ClosedLoop})
    for (const BodyPart part : {BodyPart::Feet, BodyPart::Hands, BodyPart::Head})
      EXPECT_LT(mean_error_of(part, encoded(method, {.joints = factor_of(part, 20)})),
                0.95 * mean_error_of(part, encoded(method, {})))
          << name(method) << " " << name(part);
}

TEST(Importance, ContactsKeepFeetPlanted) {
  EXPECT_LT(encoded(Method::ClosedLoop, {.contacts = 20}).footskate.total_cm,
            0.5 * encoded(Method::ClosedLoop, {}).footskate.total_cm);
}

TEST(Importance, AlikeForAllIsNone) {
  const std::vector<double> alike(static_cast<std::size_t>(walk().motion().skeleton.joint_count()),
                                  3.0);
  EXPECT_EQ(encoded(Method::ClosedLoop, {.joints = alike}).compressed.motion,
            encoded(Method::ClosedLoop, {}).compressed.motion);
}

TEST(Importance, MustBeOneNumberForEachJointAndSomeAboveZero) {
  const Skeleton& skeleton = walk().motion().skeleton;
  const auto joints = static_cast<std::size_t>(skeleton.joint_count());
  for (const std::vector<double>& bad :
       {std::vector<double>(joints - 1, 1.0), std::vector<double>(joints, 0.0),
        std::vector<double>(joints, -1.0), std::vector<double>(joints, NAN)})
    EXPECT_THROW(important_points(skeleton, Weighting::BoneEnds, {.joints = bad}), Error);
}

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

TEST(NamedImportance, EqualFactorsAreNone) {
  EXPECT_TRUE(importance_for({{{"feet", 1}, {"root", 1}}}, skeleton()).is_even());
}

TEST(NamedImportance, APartThatIsLackingIsLeftOutAJointIsRefused) {
  Skeleton bare;
  bare.add({.name = "root"});
  EXPECT_TRUE(importance_for({{{"fingers", 4}}}, bare).is_even());
  EXPECT_THROW(importance_for({{{"feets", 4}}}, bare), Error);
}

}  // namespace
}  // namespace mocapress::importance_test
