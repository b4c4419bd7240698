// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::blending_test {
namespace {

using Pose = std::vector<mcpr_transform>;

constexpr float kPi = std::numbers::pi_v<float>;

/// A turn about an axis of unit length, and a translation.
mcpr_transform turned(float radians, float x, float y, float z, float tx = 0, float ty = 0,
                      float tz = 0) {
  const float sine = std::sin(radians / 2);
  return {{std::cos(radians / 2), sine * x, sine * y, sine * z}, {tx, ty, tz, 0}};
}

mcpr_transform negated(mcpr_transform transform) {
  for (float& number : transform.rotation) number = -number;
  return transform;
}

mcpr_transform w_last(const mcpr_transform& from) {
  const float* const q = from.rotation;
  mcpr_transform to = from;
  const float moved[4] = {q[1], q[2], q[3], q[0]};
  std::copy_n(moved, 4, to.rotation);
  return to;
}

void expect_near(const mcpr_transform& got, const mcpr_transform& wanted, float most = 2e-6F) {
  float dot = 0;
  for (int i = 0; i < 4; ++i) dot += got.rotation[i] * wanted.rotation[i];
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(got.rotation[i], dot < 0 ? -wanted.rotation[i] : wanted.rotation[i], most);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(got.translation[i], wanted.translation[i], 50 * most);
}

void expect_same_bits(const mcpr_transform& got, const mcpr_transform& wanted) {
  EXPECT_EQ(std::memcmp(&got, &wanted, sizeof got), 0);
}

/// a * b, each a transform to the parent's space.
mcpr_transform product(const mcpr_transform& a, const mcpr_transform& b) {
  const float* const p = a.rotation;
  const float* const q = b.rotation;
  mcpr_transform out{{p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                      p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                      p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                      p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]},
                     {}};
  const float* const t = b.translation;
  const float m[3][3] = {{1 - 2 * (p[2] * p[2] + p[3] * p[3]), 2 * (p[1] * p[2] - p[0] * p[3]),
                          2 * (p[1] * p[3] + p[0] * p[2])},
                         {2 * (p[1] * p[2] + p[0] * p[3]), 1 - 2 * (p[1] * p[1] + p[3] * p[3]),
                          2 * (p[2] * p[3] - p[0] * p[1])},
                         {2 * (p[1] * p[3] - p[0] * p[2]), 2 * (p[2] * p[3] + p[0] * p[1]),
                          1 - 2 * (p[1] * p[1] + p[2] * p[2])}};
  for (int i = 0; i < 3; ++i)
    out.translation[i] = a.translation[i] + m[i][0] * t[0] + m[i][1] * t[1] + m[i][2] * t[2];
  return out;
}

/// Poses that need no library's sine: quaternions of whole numbers, normalised.
Pose some_pose(unsigned seed, std::uint32_t joints) {
  Pose pose(joints);
  const auto number = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<float>(static_cast<int>(seed >> 16) % 201 - 100);
  };
  for (mcpr_transform& joint : pose) {
    float squares = 0;
    for (float& part : joint.rotation) {
      part = number();
      squares += part * part;
    }
    if (squares == 0) joint.rotation[0] = squares = 1;
    for (float& part : joint.rotation) part /= std::sqrt(squares);
    for (int i = 0; i < 3; ++i) joint.translation[i] = number() / 4;
    joint.translation[3] = 0;
  }
  return pose;
}

std::uint64_t hash_of(const Pose& pose, std::uint64_t hash) {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(pose.data());
  for (std::size_t i = 0; i < pose.size() * sizeof(mcpr_transform); ++i)
    hash = (hash ^ bytes[i]) * 1099511628211U;
  return hash;
}

mcpr_transform blended(const std::vector<mcpr_transform>& poses,
                       const std::vector<float>& weights) {
  const mcpr_pose_form form{.joints = 1};
  std::vector<mcpr_weighted_pose> all;
  for (std::size_t i = 0; i < poses.size(); ++i)
    all.push_back({.pose = &poses[i], .weight = weights[i]});
  mcpr_transform out{};
  EXPECT_EQ(mcpr_blend(&form, all.data(), static_cast<std::uint32_t>(all.size()), &out, nullptr),
            MCPR_OK);
  return out;
}

TEST(Blending, HalfOfEachTurnsHalfway) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0, 2, 0, 0);
  const mcpr_transform b = turned(1.0F, 0, 1, 0, 4, 6, 0);
  expect_near(blended({a, b}, {0.5F, 0.5F}), turned(0.6F, 0, 1, 0, 3, 3, 0));
}

TEST(Blending, WeightsNeedNotAddUpToOne) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0, 2, 0, 0);
  const mcpr_transform b = turned(1.0F, 1, 0, 0, 4, 6, 0);
  const mcpr_transform c = turned(-0.5F, 0, 0, 1, 1, 1, 1);
  expect_near(blended({a, b, c}, {3, 6, 1}), blended({a, b, c}, {0.3F, 0.6F, 0.1F}));
  expect_near(blended({a, b, c}, {3e5F, 6e5F, 1e5F}), blended({a, b, c}, {3e-5F, 6e-5F, 1e-5F}));
}

TEST(Blending, SignsOfQuaternionsDoNotMatter) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0);
  const mcpr_transform b = turned(1.0F, 1, 0, 0);
  const mcpr_transform c = turned(-0.5F, 0, 0, 1);
  for (const mcpr_transform& first : {a, negated(a)})
    for (const mcpr_transform& second : {b, negated(b)})
      for (const mcpr_transform& third : {c, negated(c)})
        expect_near(blended({first, second, third}, {0.3F, 0.5F, 0.2F}),
                    blended({a, b, c}, {0.3F, 0.5F, 0.2F}));
}

TEST(Blending, RotationsStayUnitEvenBetweenOpposites) {
  const mcpr_transform none = turned(0, 0, 1, 0);
  const mcpr_transform half = turned(kPi, 0, 1, 0);
  const mcpr_transform tilted = turned(kPi, 1, 0, 0);
  for (const float weight : {0.0F, 1e-3F, 0.5F, 0.9F}) {
    const mcpr_transform out = blended({none, half, tilted}, {1 - weight, weight, weight});
    float squares = 0;
    for (const float number : out.rotation) squares += number * number;
    EXPECT_NEAR(squares, 1, 1e-6);
  }
}

TEST(Blending, TheOnlyPoseThatCountsIsTakenBitByBit) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0, 2, 1e-3F, 0);
  const mcpr_transform b = turned(1.0F, 1, 0, 0, 4, 6, 0.1F);
  expect_same_bits(blended({a, b}, {0, 0.3F}), b);
  expect_same_bits(blended({a, b}, {1e-7F, 7}), b);
  expect_same_bits(blended({b}, {0.7F}), b);
}

TEST(Blending, PosesWithoutWeightDoNotCount) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0, 2, 0, 0);
  const mcpr_transform b = turned(1.0F, 1, 0, 0, 4, 6, 0);
  mcpr_transform broken = a;
  broken.translation[0] = std::numeric_limits<float>::quiet_NaN();
  broken.rotation[0] = std::numeric_limits<float>::quiet_NaN();
  expect_same_bits(blended({broken, a, broken, b}, {0, 1, 9e-7F, 1}), blended({a, b}, {1, 1}));
}

TEST(Blending, WithoutAnyWeightTheFirstPoseIsTaken) {
  const mcpr_transform a = turned(0.2F, 0, 1, 0, 2, 1e-3F, 0);
  expect_same_bits(blended({a, turned(1, 1, 0, 0)}, {0, 0}), a);
}

TEST(Blending, AMaskChoosesJointByJoint) {
  const Pose legs = some_pose(1, 3);
  const Pose arms = some_pose(2, 3);
  const float mask[] = {0, 0.5F, 1};
  const float rest[] = {1, 0.5F, 0};
  const mcpr_pose_form form{.joints = 3};
  const mcpr_weighted_pose both[] = {{.pose = legs.data(), .weight = 1, .joint_weights = rest},
                                     {.pose = arms.data(), .weight = 1, .joint_weights = mask}};
  Pose out = legs;  // the output may be an input
  ASSERT_EQ(mcpr_blend(&form, both, 2, out.data(), nullptr), MCPR_OK);
  expect_same_bits(out[0], legs[0]);
  expect_near(out[1], blended({legs[1], arms[1]}, {1, 1}));
  expect_same_bits(out[2], arms[2]);
  Pose layered = legs;
  ASSERT_EQ(mcpr_blend_layer(&form, &both[1], layered.data(), nullptr), MCPR_OK);
  for (std::size_t j = 0; j < 3; ++j) expect_near(layered[j], out[j]);
  expect_same_bits(layered[0], legs[0]);
  expect_same_bits(layered[2], arms[2]);
}

TEST(Blending, ADifferenceAddedToItsBaseGivesThePose) {
  const Pose base = some_pose(1, 20);
  const Pose pose = some_pose(2, 20);
  const mcpr_pose_form form{.joints = 20};
  Pose difference(20);
  ASSERT_EQ(mcpr_pose_difference(&form, pose.data(), base.data(), difference.data(), nullptr),
            MCPR_OK);
  Pose sum = base;
  const mcpr_weighted_pose whole{.pose = difference.data(), .weight = 1};
  ASSERT_EQ(mcpr_blend_additive(&form, &whole, sum.data(), nullptr), MCPR_OK);
  for (std::size_t j = 0; j < sum.size(); ++j) expect_near(sum[j], pose[j]);
}

TEST(Blending, APartOfADifferenceTurnsByThatPart) {
  const mcpr_transform base = turned(0.7F, 1, 0, 0, 0, 10, 0);
  const mcpr_transform difference = turned(0.8F, 0, 1, 0, 2, 0, 4);
  const mcpr_pose_form form{.joints = 1};
  for (const mcpr_transform& either : {difference, negated(difference)}) {
    mcpr_transform pose = base;
    const mcpr_weighted_pose half{.pose = &either, .weight = 0.5F};
    ASSERT_EQ(mcpr_blend_additive(&form, &half, &pose, nullptr), MCPR_OK);
    mcpr_transform wanted = product(turned(0.4F, 0, 1, 0), base);
    const float sum[] = {1, 10, 2};
    std::copy_n(sum, 3, wanted.translation);
    expect_near(pose, wanted);
    const mcpr_weighted_pose none{.pose = &either, .weight = 0};
    pose = base;
    ASSERT_EQ(mcpr_blend_additive(&form, &none, &pose, nullptr), MCPR_OK);
    expect_same_bits(pose, base);
  }
}

TEST(Blending, QuaternionsMayHaveWLast) {
  const mcpr_convention last{.w_last = 1};
  const mcpr_pose_form own{.joints = 4};
  const mcpr_pose_form form{.joints = 4, .convention = &last};
  const Pose base = some_pose(1, 4);
  const Pose pose = some_pose(2, 4);
  Pose other_base;
  Pose other_pose;
  for (const mcpr_transform& joint : base) other_base.push_back(w_last(joint));
  for (const mcpr_transform& joint : pose) other_pose.push_back(w_last(joint));
  Pose difference(4);
  Pose other(4);
  mcpr_pose_difference(&own, pose.data(), base.data(), difference.data(), nullptr);
  ASSERT_EQ(
      mcpr_pose_difference(&form, other_pose.data(), other_base.data(), other.data(), nullptr),
      MCPR_OK);
  for (std::size_t j = 0; j < 4; ++j) expect_same_bits(other[j], w_last(difference[j]));
}

TEST(Blending, ARootIsSplitIntoGroundAndRest) {
  const mcpr_transform root =
      product(turned(2.5F, 0, 1, 0, 30, 0, -40), turned(0.3F, 1, 0, 0, 0, 95, 0));
  mcpr_transform rest = root;
  mcpr_transform ground{};
  ASSERT_EQ(mcpr_split_root(nullptr, &rest, &ground, nullptr), MCPR_OK);
  expect_near(ground, turned(2.5F, 0, 1, 0, 30, 0, -40));
  expect_near(rest, turned(0.3F, 1, 0, 0, 0, 95, 0));
  expect_near(product(ground, rest), root);
}

TEST(Blending, TheAxisThatPointsUpIsTheConventions) {
  mcpr_convention unreal{};
  ASSERT_EQ(mcpr_convention_of(MCPR_UNREAL, &unreal, nullptr), MCPR_OK);
  mcpr_transform root = w_last(turned(1.5F, 0, 0, 1, 30, -40, 95));
  mcpr_transform ground{};
  ASSERT_EQ(mcpr_split_root(&unreal, &root, &ground, nullptr), MCPR_OK);
  expect_near(ground, w_last(turned(1.5F, 0, 0, 1, 30, -40, 0)));
  expect_near(root, {{0, 0, 0, 1}, {0, 0, 95, 0}});
}

TEST(Blending, ARootThatFacesNowhereKeepsItsTurn) {
  const mcpr_transform upside_down{{0, 1, 0, 0}, {1, 2, 3, 0}};
  mcpr_transform rest = upside_down;
  mcpr_transform ground{};
  ASSERT_EQ(mcpr_split_root(nullptr, &rest, &ground, nullptr), MCPR_OK);
  expect_near(ground, {{1, 0, 0, 0}, {1, 0, 3, 0}});
  expect_near(product(ground, rest), upside_down);
}

/// Hips, a spine, and a left and a right arm of two joints each, whose axes do not agree.
struct Figure {
  std::vector<std::int16_t> parents = {-1, 0, 1, 2, 1, 4};
  std::vector<std::uint16_t> partners = {0, 1, 4, 5, 2, 3};
  Pose bind = {turned(0.1F, 1, 0, 0, 0, 90, 0),
               turned(-0.1F, 1, 0, 0, 0, 30, 0),
               turned(1.1F, 0, 0, 1, 20, 10, 0),
               turned(0.4F, 0, 1, 0, 25, 0, 0),
               product(turned(-1.1F, 0, 0, 1, -20, 10, 0), turned(2.0F, 1, 0, 0)),
               turned(0.9F, 0, 0, 1)};

  /// Places of the joints in the character's space.
  Pose in_model(const Pose& pose) const {
    Pose all = pose;
    for (std::size_t j = 0; j < pose.size(); ++j)
      if (parents[j] >= 0) all[j] = product(all[static_cast<std::size_t>(parents[j])], pose[j]);
    return all;
  }

  Figure() {
    // The right forearm lies where the left one's mirror image does.
    const Pose model = in_model(bind);
    const float* const left = model[3].translation;
    const mcpr_transform& arm = model[4];
    mcpr_transform back{{arm.rotation[0], -arm.rotation[1], -arm.rotation[2], -arm.rotation[3]},
                        {}};
    const mcpr_transform place =
        product(back, {{1, 0, 0, 0},
                       {-left[0] - arm.translation[0], left[1] - arm.translation[1],
                        left[2] - arm.translation[2], 0}});
    std::copy_n(place.translation, 3, bind[5].translation);
  }

  Pose mirrored(const Pose& pose) const {
    const mcpr_pose_form form{.joints = 6};
    std::vector<mcpr_mirror_joint> mirror(6);
    EXPECT_EQ(mcpr_make_mirror(&form, bind.data(), parents.data(), partners.data(), 0,
                               mirror.data(), nullptr),
              MCPR_OK);
    Pose out(6);
    EXPECT_EQ(mcpr_mirror_pose(&form, mirror.data(), 0, pose.data(), out.data(), nullptr), MCPR_OK);
    return out;
  }
};

TEST(Mirror, JointsAreWhereTheirPartnersImagesAre) {
  const Figure figure;
  Pose pose = figure.bind;
  for (std::size_t j = 0; j < pose.size(); ++j)
    pose[j] = product(pose[j], turned(0.3F + 0.2F * static_cast<float>(j), 0, 0.6F, 0.8F));
  pose[0].translation[0] = 12;
  const Pose model = figure.in_model(pose);
  const Pose mirrored = figure.in_model(figure.mirrored(pose));
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const float* const wanted = model[figure.partners[j]].translation;
    EXPECT_NEAR(mirrored[j].translation[0], -wanted[0], 1e-3);
    EXPECT_NEAR(mirrored[j].translation[1], wanted[1], 1e-3);
    EXPECT_NEAR(mirrored[j].translation[2], wanted[2], 1e-3);
  }
}

TEST(Mirror, TheBindPoseStaysAndTwiceIsBack) {
  const Figure figure;
  const Pose bind = figure.mirrored(figure.bind);
  for (std::size_t j = 0; j < bind.size(); ++j) expect_near(bind[j], figure.bind[j], 1e-5F);
  const Pose pose = some_pose(3, 6);
  const Pose back = figure.mirrored(figure.mirrored(pose));
  for (std::size_t j = 0; j < pose.size(); ++j) expect_near(back[j], pose[j], 1e-5F);
}

TEST(Mirror, PartnersThatDoNotAgreeAreRefused) {
  const Figure figure;
  const mcpr_pose_form form{.joints = 6};
  std::vector<mcpr_mirror_joint> mirror(6);
  const auto status_of = [&](const std::vector<std::uint16_t>& partners, int axis) {
    return mcpr_make_mirror(&form, figure.bind.data(), figure.parents.data(), partners.data(), axis,
                            mirror.data(), nullptr);
  };
  EXPECT_EQ(status_of(figure.partners, 0), MCPR_OK);
  EXPECT_EQ(status_of(figure.partners, 3), MCPR_ARGUMENT);
  EXPECT_EQ(status_of({0, 1, 4, 5, 3, 2}, 0), MCPR_ARGUMENT);
  EXPECT_EQ(status_of({0, 1, 5, 4, 3, 2}, 0), MCPR_ARGUMENT);
  EXPECT_EQ(status_of({0, 1, 4, 5, 2, 6}, 0), MCPR_ARGUMENT);
  mirror[2].partner = 6;
  Pose out(6);
  EXPECT_EQ(mcpr_mirror_pose(&form, mirror.data(), 0, figure.bind.data(), out.data(), nullptr),
            MCPR_ARGUMENT);
}

TEST(Blending, WeightsThatMakeNoSenseAreRefused) {
  const Pose a = some_pose(1, 2);
  Pose out = some_pose(2, 2);
  const mcpr_pose_form form{.joints = 2};
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const float weight : {-1.0F, kNaN, kInfinite, 2e6F}) {
    const float mask[] = {1, weight};
    const mcpr_weighted_pose all{.pose = a.data(), .weight = weight};
    const mcpr_weighted_pose masked{.pose = a.data(), .weight = 1, .joint_weights = mask};
    for (const mcpr_weighted_pose* const pose : {&all, &masked}) {
      EXPECT_EQ(mcpr_blend(&form, pose, 1, out.data(), nullptr), MCPR_ARGUMENT);
      EXPECT_EQ(mcpr_blend_layer(&form, pose, out.data(), nullptr), MCPR_ARGUMENT);
      EXPECT_EQ(mcpr_blend_additive(&form, pose, out.data(), nullptr), MCPR_ARGUMENT);
    }
  }
  const float minus[] = {-1, -1};
  const mcpr_weighted_pose twice{.pose = a.data(), .weight = -1, .joint_weights = minus};
  EXPECT_EQ(mcpr_blend(&form, &twice, 1, out.data(), nullptr), MCPR_ARGUMENT);
  const mcpr_weighted_pose more{.pose = a.data(), .weight = 1.5F};
  EXPECT_EQ(mcpr_blend_layer(&form, &more, out.data(), nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_blend_additive(&form, &more, out.data(), nullptr), MCPR_ARGUMENT);
  const mcpr_convention impossible{.axes = {1, 1, 2}};
  const mcpr_pose_form no_form{.joints = 2, .convention = &impossible};
  EXPECT_EQ(mcpr_blend(&no_form, &twice, 1, out.data(), nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_blend(&form, nullptr, 1, out.data(), nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_blend(nullptr, &more, 1, out.data(), nullptr), MCPR_ARGUMENT);
}

/// tests/cross compares blends of real poses on every processor; this pins their bits for good.
TEST(Blending, BitsAreTheSameEverywhere) {
  constexpr std::uint32_t kJoints = 64;
  const mcpr_pose_form form{.joints = kJoints};
  const Pose poses[] = {some_pose(1, kJoints), some_pose(2, kJoints), some_pose(3, kJoints)};
  std::vector<float> mask;
  for (std::uint32_t j = 0; j < kJoints; ++j) mask.push_back(static_cast<float>(j % 9) / 8);
  std::uint64_t hash = 14695981039346656037U;
  Pose out(kJoints);
  const mcpr_weighted_pose all[] = {
      {.pose = poses[0].data(), .weight = 0.3F},
      {.pose = poses[1].data(), .weight = 2, .joint_weights = mask.data()},
      {.pose = poses[2].data(), .weight = 0.7F}};
  ASSERT_EQ(mcpr_blend(&form, all, 3, out.data(), nullptr), MCPR_OK);
  hash = hash_of(out, hash);
  const mcpr_weighted_pose layer{
      .pose = poses[1].data(), .weight = 0.9F, .joint_weights = mask.data()};
  ASSERT_EQ(mcpr_blend_layer(&form, &layer, out.data(), nullptr), MCPR_OK);
  hash = hash_of(out, hash);
  ASSERT_EQ(mcpr_pose_difference(&form, out.data(), poses[0].data(), out.data(), nullptr), MCPR_OK);
  hash = hash_of(out, hash);
  Pose sum = poses[1];
  const mcpr_weighted_pose added{.pose = out.data(), .weight = 0.6F, .joint_weights = mask.data()};
  ASSERT_EQ(mcpr_blend_additive(&form, &added, sum.data(), nullptr), MCPR_OK);
  hash = hash_of(sum, hash);
  std::vector<std::int16_t> parents;
  std::vector<std::uint16_t> partners;
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    parents.push_back(static_cast<std::int16_t>(static_cast<int>(j) - (j < 2 ? 1 : 2)));
    partners.push_back(static_cast<std::uint16_t>(j == 0 ? 0 : j));
  }
  std::vector<mcpr_mirror_joint> mirror(kJoints);
  ASSERT_EQ(mcpr_make_mirror(&form, poses[0].data(), parents.data(), partners.data(), 0,
                             mirror.data(), nullptr),
            MCPR_OK);
  ASSERT_EQ(mcpr_mirror_pose(&form, mirror.data(), 0, sum.data(), out.data(), nullptr), MCPR_OK);
  hash = hash_of(out, hash);
  for (mcpr_transform& root : out) {
    mcpr_transform ground{};
    ASSERT_EQ(mcpr_split_root(nullptr, &root, &ground, nullptr), MCPR_OK);
    hash = hash_of({root, ground}, hash);
  }
  EXPECT_EQ(hash, 6649208920136080047U);
}

}  // namespace
}  // namespace mocapress::blending_test
