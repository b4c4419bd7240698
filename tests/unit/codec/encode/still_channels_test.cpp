// SPDX-License-Identifier: MIT
// A channel that is constant in the original is constant in the file.
#include <gtest/gtest.h>

#include <cmath>

#include "core/codec/encode/encoder.h"
#include "core/codec/encode/segmented_encode.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/game_like.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// `rounding`: a still channel's range, as a share of its value.
void expect_still_where_the_original_is(const Motion& motion, const EncodeSettings& options,
                                        double rounding = 0) {
  const Clip decoded = Encoder(motion).encode(options).decoded;
  const std::vector<bool> still = still_channels(motion.clip);
  int count = 0;
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    if (!still[static_cast<std::size_t>(c)]) continue;
    ++count;
    const auto channel = decoded.channels.col(c);
    EXPECT_LE(channel.maxCoeff() - channel.minCoeff(), rounding * std::abs(channel(0))) << c;
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

TEST(StillChannels, StayStillInClipsOfAnyLengthWhateverTheirValue) {
  for (const int frames : {1, 2, 3, 4, 7, 12, 49, 97, 200})
    for (const double value : {0.001, 17.77, 91.3, -1234.5, 98765.4}) {
      Motion motion = with_still_channels(test::smooth_motion(frames));
      motion.clip.channels.col(1).setConstant(value);
      expect_still_where_the_original_is(motion, closed_loop({Target::Kind::Error, 0.1}));
    }
}

/// The last segment may have another number of bands than the others.
TEST(StillChannels, StayStillAcrossSegmentsOfOtherLengths) {
  EncodeSettings options = closed_loop({Target::Kind::Error, 0.5});
  for (const auto& [frames, longest, overlap] :
       {std::tuple{700, 256, 48}, {768, 385, 1}, {1152, 385, 2}}) {
    options.segments = {.longest = longest, .overlap = overlap};
    ASSERT_GT(even_segments(frames, options.segments).count(), 1);
    expect_still_where_the_original_is(with_still_channels(test::smooth_motion(frames, 5)),
                                       options);
  }
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

/// The file holds one value, but sums of equal neighbours are rounded to floats.
TEST(StillChannels, StayStillByThePapersMethodsButForTheRoundingOfFloats) {
  constexpr double kRounding = 1e-6;
  for (const int frames : {12, 97, 300})
    for (const double value : {0.001, 17.77, -1234.5}) {
      Motion motion = with_still_channels(test::smooth_motion(frames));
      motion.clip.channels.col(1).setConstant(value);
      for (const Method method : {Method::PerChannel, Method::Standard, Method::Annealed})
        for (const Coding coding : {Coding::Rle16, Coding::Deflate, Coding::Adaptive})
          for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
            for (const double ratio : {4, 15, 60})
              expect_still_where_the_original_is(
                  motion,
                  {.method = method,
                   .coding = coding,
                   .basis = basis,
                   .target = {Target::Kind::CoefficientRatio, ratio}},
                  kRounding);
    }
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
