// SPDX-License-Identifier: MIT
#include "core/motion/loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// Limbs that swing once in `turn_frames`; the root walks 1 cm a frame along an arc that turns by
/// `heading` about the vertical.
Motion walk(int turn_frames, int frames, double heading = 1e-6) {
  Motion motion = test::smooth_motion(frames);
  const Skeleton& skeleton = motion.skeleton;
  const double radius = frames / heading;  // cm
  const int root_channels = static_cast<int>(skeleton.joint(0).channels.size());
  for (int c = 0; c < skeleton.channel_count(); ++c)
    for (int t = 0; t < frames; ++t) {
      const double phase = 2 * std::numbers::pi * t / turn_frames;
      double& value = motion.clip.channels(t, c);
      value = 0.3 * std::sin(phase + c) + 0.1 * std::cos(2 * phase);
      if (c >= root_channels) continue;
      const ChannelKind kind = skeleton.channel_kind(c);
      const double turned = t / radius;
      if (kind == ChannelKind::TranslationX) value = radius * std::sin(turned);
      if (kind == ChannelKind::TranslationZ) value = radius * (1 - std::cos(turned));
      if (is_rotation(kind)) value = kind == ChannelKind::RotationY ? -turned : 0;
    }
  return motion;
}

TEST(Loop, IsFoundWhereTheLastFrameIsTheFirstAgain) {
  EXPECT_EQ(find_loop(walk(60, 121)), Loop::Repeats);
}

TEST(Loop, IsFoundWhereTheFirstFrameFollowsUponTheLast) {
  EXPECT_EQ(find_loop(walk(60, 120)), Loop::Follows);
}

TEST(Loop, IsFoundWhereTheCharacterEndsElsewhereAndHeadsElsewhere) {
  for (const double heading : {-3.0, 0.5, 2.0}) {
    EXPECT_EQ(find_loop(walk(60, 121, heading)), Loop::Repeats) << heading;
    EXPECT_EQ(find_loop(walk(60, 120, heading)), Loop::Follows) << heading;
  }
}

TEST(Loop, IsNoneWhereThePoseOrItsVelocityDiffers) {
  EXPECT_EQ(find_loop(walk(60, 100)), Loop::None);
  EXPECT_EQ(find_loop(walk(60, 91)), Loop::None);
  EXPECT_EQ(find_loop(test::smooth_motion(200)), Loop::None);
}

TEST(Loop, IsNoneOfAClipThatStandsStillOrIsShort) {
  Motion still = test::smooth_motion(50);
  still.clip.channels.rowwise() = still.clip.channels.row(0).eval();
  EXPECT_EQ(find_loop(still), Loop::None);
  for (const int frames : {0, 1, 2, 3})
    EXPECT_EQ(find_loop(test::smooth_motion(frames)), Loop::None);
}

}  // namespace
}  // namespace mocapress
