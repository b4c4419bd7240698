// SPDX-License-Identifier: MIT
#include "core/ik/knee.h"
#include "core/feet/feet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

TEST(Knee, IsTheSecondJointOfALeg) {
  const Skeleton skeleton = samples::walk_clip().skeleton;
  for (const Effector& foot : find_feet(skeleton))
    EXPECT_NE(skeleton.joint(knee_of(foot)).name.find("tibia"), std::string::npos);
}

TEST(Knee, FastestTurnIsTheOneThatWasPlanted) {
  Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  motion.clip.channels.setZero();
  EXPECT_EQ(fastest_knee(motion.skeleton, feet, motion.clip), 0);
  const int channel = motion.skeleton.first_channel(knee_of(feet.back()));
  motion.clip.channels.col(channel).tail(10).setConstant(0.25);
  EXPECT_NEAR(fastest_knee(motion.skeleton, feet, motion.clip), 0.25 * motion.clip.sample_rate_hz,
              1e-9);
}

TEST(Knee, AWholeTurnIsNoTurn) {
  Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  const double before = fastest_knee(motion.skeleton, feet, motion.clip);
  const int channel = motion.skeleton.first_channel(knee_of(feet.front()));
  motion.clip.channels.col(channel).tail(10).array() += 2 * std::numbers::pi;
  EXPECT_NEAR(fastest_knee(motion.skeleton, feet, motion.clip), before, 1e-9);
}

TEST(Knee, OfBlocksIsThatOfTheWhole) {
  const Motion motion = samples::walk_clip();
  const std::vector<Effector> feet = find_feet(motion.skeleton);
  KneeSpeed speed(motion.skeleton, feet);
  for (int first = 0; first < motion.clip.frames(); first += 13)
    speed.add({motion.clip.sample_rate_hz,
               motion.clip.channels.middleRows(first, std::min(13, motion.clip.frames() - first))});
  EXPECT_EQ(speed.fastest(), fastest_knee(motion.skeleton, feet, motion.clip));
  EXPECT_GT(speed.fastest(), 0);
}

}  // namespace
}  // namespace mocapress
