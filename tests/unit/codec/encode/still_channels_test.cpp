// SPDX-License-Identifier: MIT
// A channel that is constant in the original is constant in the file.
#include <gtest/gtest.h>

#include "core/codec/encode/encoder.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/game_like.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kRounding = 1e-4;  // of floats, at a metre from the origin, in cm

void expect_still_where_the_original_is(const Motion& motion, const EncodeSettings& options,
                                        double within = kRounding) {
  const Clip decoded = Encoder(motion).encode(options).decoded;
  const std::vector<bool> still = still_channels(motion.clip);
  int count = 0;
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    if (!still[static_cast<std::size_t>(c)]) continue;
    ++count;
    const auto channel = decoded.channels.col(c);
    EXPECT_LE(channel.maxCoeff() - channel.minCoeff(), within) << c;
  }
  EXPECT_GT(count, 0);
}

Motion with_still_channels(Motion motion) {
  motion.clip.channels.col(0).setZero();
  motion.clip.channels.col(1).setConstant(91.3);
  motion.clip.channels.col(7).setConstant(0.31);
  return motion;
}

EncodeSettings closed_loop(Target target) {
  return {.method = Method::ClosedLoop, .weighting = Weighting::Surface, .target = target};
}

TEST(StillChannels, StayStillAtEveryTarget) {
  const Motion motion = with_still_channels(test::smooth_motion(300));
  for (const Target target : {Target{Target::Kind::Error, 1.0}, Target{Target::Kind::Error, 0.05},
                              Target{Target::Kind::Ratio, 60}, Target{Target::Kind::MaxError, 2}})
    expect_still_where_the_original_is(motion, closed_loop(target));
}

TEST(StillChannels, StayStillInRigsOfGames) {
  expect_still_where_the_original_is(test::game_like(samples::walk_clip()),
                                     closed_loop({Target::Kind::Error, 0.5}));
}

/// Segments of another length round their constants otherwise.
TEST(StillChannels, MoveByLessThanAFifthOfAMillimetreAcrossSegments) {
  EncodeSettings options = closed_loop({Target::Kind::Error, 0.5});
  options.segments.longest = 256;
  expect_still_where_the_original_is(with_still_channels(test::smooth_motion(700, 5)), options,
                                     0.02);
}

TEST(StillChannels, StayStillAtExactEndsAndInLoops) {
  EncodeSettings options = closed_loop({Target::Kind::Error, 0.5});
  options.ends = Ends::Exact;
  const Motion motion = with_still_channels(test::smooth_motion(300));
  expect_still_where_the_original_is(motion, options);
  options.ends = Ends::Even;
  options.loop = Loop::Repeats;
  expect_still_where_the_original_is(motion, options);
}

TEST(StillChannels, KeepTheirValueToASixteenthOfTheScale) {
  const Motion motion = with_still_channels(test::smooth_motion(300));
  const Encoding encoding = Encoder(motion).encode(closed_loop({Target::Kind::Error, 0.5}));
  EXPECT_EQ(encoding.decoded.channels(0, 0), 0);
  EXPECT_NEAR(encoding.decoded.channels(0, 1), 91.3, 0.15);
  EXPECT_NEAR(encoding.decoded.channels(0, 7), 0.31, 0.15);
}

}  // namespace
}  // namespace mocapress
