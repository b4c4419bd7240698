// SPDX-License-Identifier: MIT
#include "core/motion/additive.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mocapress::additive_test {
namespace {

/// A figure of hips, spine, head, two legs and feet, all of whose angles swing up to `radians`.
Motion swinging(double radians) {
  using enum ChannelKind;
  Skeleton skeleton;
  skeleton.add({.name = "Hips", .channels = {TranslationX, TranslationY, TranslationZ, RotationZ}});
  const auto add = [&](const char* name, int parent, const Eigen::Vector3d& offset) {
    return skeleton.add(
        {.name = name, .parent = parent, .offset = offset, .channels = {RotationX}});
  };
  add("Head", add("Spine", 0, {0, 20, 0}), {0, 40, 0});
  for (const double side : {-9.0, 9.0})
    add("Foot", add("Knee", add("Leg", 0, {side, 0, 0}), {0, -42, 0}), {0, -43, 0});
  Clip clip{30, Eigen::MatrixXd::Zero(40, skeleton.channel_count())};
  for (Eigen::Index c = 3; c < clip.channels.cols(); ++c)
    for (int t = 0; t < 40; ++t)
      clip.channels(t, c) = radians * std::sin(t / 6.0 + static_cast<double>(c));
  return {skeleton, clip};
}

TEST(Additive, IsAFigureNearRestWithItsRootAtTheOrigin) {
  EXPECT_TRUE(looks_additive(swinging(0.3)));
}

TEST(Additive, IsNoFigureThatStands) {
  Motion motion = swinging(0.3);
  motion.clip.channels.col(1).setConstant(85);
  EXPECT_FALSE(looks_additive(motion));
}

TEST(Additive, IsNothingThatTurnsFarOrDoesNotMove) {
  EXPECT_FALSE(looks_additive(swinging(1.2)));
  EXPECT_FALSE(looks_additive(swinging(0)));
}

TEST(Additive, IsNoThingWithoutLegs) {
  Motion motion = swinging(0.3);
  Skeleton upwards;
  for (Joint joint : motion.skeleton.joints()) {
    joint.offset.y() = std::abs(joint.offset.y());
    upwards.add(joint);
  }
  motion.skeleton = upwards;
  EXPECT_FALSE(looks_additive(motion));
}

}  // namespace
}  // namespace mocapress::additive_test
