// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/scale_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/codec/encode/encoder.h"
#include "core/metrics/rate.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/test_motion.h"

namespace mocapress::scale_search_test {
namespace {

const Encoder& run() {
  static const Encoder shared(samples::run_clip());
  return shared;
}

Encoding encoded(Target target, Effort effort) {
  return run().encode({.method = Method::ClosedLoop,
                       .weighting = Weighting::BoneEnds,
                       .target = target,
                       .effort = effort});
}

TEST(ScaleSearch, MeetsEveryKindOfTargetWithinTwoPercent) {
  const auto raw = static_cast<double>(raw_bytes(run().motion().clip));
  for (const Effort effort : {Effort::Default, Effort::Best}) {
    const auto bytes = [&](Target target) {
      return static_cast<double>(encoded(target, effort).compressed.motion_bytes());
    };
    for (const double ratio : {20, 60, 150})
      EXPECT_NEAR(raw / bytes({Target::Kind::Ratio, ratio}) / ratio, 1, 0.02);
    const double size = bytes({Target::Kind::Size, 3000});
    EXPECT_LE(size, 3000);
    EXPECT_GT(size, 0.96 * 3000);
    for (const double eps : {0.05, 0.2, 1.0}) {
      const double achieved = encoded({Target::Kind::Error, eps}, effort).distortion.eps_bone_ends;
      EXPECT_LE(achieved, eps);
      // The best effort keeps the cheapest that it finds, which need not be the nearest.
      EXPECT_GT(achieved, (effort == Effort::Best ? 0.93 : 0.96) * eps);
    }
    for (const double bound : {0.4, 1.5, 4.0}) {
      const double furthest = encoded({Target::Kind::MaxError, bound}, effort).distortion.max.cm;
      EXPECT_LE(furthest, bound);
      EXPECT_GT(furthest, 0.98 * bound);
    }
  }
}

TEST(ScaleSearch, MeetsAVisibilityTarget) {
  const auto seen = [](double times, const EncodeSettings& more) {
    EncodeSettings options = more;
    options.target = {Target::Kind::Visibility, times};
    return run().encode(options);
  };
  const Encoding hidden = seen(1, {});
  EXPECT_EQ(hidden.visibility.sight(), Sight::NotVisible);
  EXPECT_GT(hidden.visibility.worst().times_noticed(), 0.7);
  const Encoding borderline = seen(2, {});
  EXPECT_EQ(borderline.visibility.sight(), Sight::Borderline);
  EXPECT_LT(borderline.compressed.motion_bytes(), hidden.compressed.motion_bytes());
  EncodeSettings corrected;
  corrected.correction.emplace().ratio = 16;
  EXPECT_EQ(seen(1, corrected).visibility.sight(), Sight::NotVisible);
}

TEST(ScaleSearch, HoldsAHardMaximumWithACorrectionToo) {
  for (const double bound : {1.5, 3.0}) {
    EncodeSettings options{.method = Method::ClosedLoop,
                           .weighting = Weighting::BoneEnds,
                           .target = {Target::Kind::MaxError, bound}};
    options.correction.emplace().ratio = 16;
    const double furthest = run().encode(options).distortion.max.cm;
    EXPECT_LE(furthest, bound);
    EXPECT_GT(furthest, 0.99 * bound);
  }
}

TEST(ScaleSearch, FindsSomethingSmallerWithTheBestEffort) {
  const auto bytes = [](Effort effort) {
    return encoded({Target::Kind::Error, 0.3}, effort).compressed.motion_bytes();
  };
  EXPECT_LT(static_cast<double>(bytes(Effort::Best)),
            0.995 * static_cast<double>(bytes(Effort::Default)));
}

TEST(ScaleSearch, ADraftIsNearTheTarget) {
  const Encoding by_error = encoded({Target::Kind::Error, 0.3}, Effort::Draft);
  EXPECT_NEAR(by_error.distortion.eps_bone_ends / 0.3, 1, 0.35);
  const Encoding by_ratio = encoded({Target::Kind::Ratio, 60}, Effort::Draft);
  EXPECT_NEAR(compression_ratio(run().motion().clip, by_ratio.compressed.motion_bytes()) / 60, 1,
              0.35);
}

TEST(ScaleSearch, LooksRoughlyAgainWhereARoughTrialIsFarTooCoarse) {
  const Motion motion = test::smooth_motion(3);
  const Target target{Target::Kind::Ratio, 25};
  const Goal goal(Original(motion), target, Weighting::Surface, {});
  constexpr double kWanted = 1e-5;  // the scale that meets the target
  int rough = 0;
  int swept = 0;
  const auto attempt = [&](double scale, ClosedLoopWork work, const Eigen::VectorXd&) {
    ++(work == ClosedLoopWork::Rounding ? rough : swept);
    return Trial{.scale = scale, .excess = std::log(kWanted / scale) / 1.7};
  };
  const ScaleGuess guess{.likely = 1, .finest = [] { return 1e-9; }};
  const Trial best = search_scale(guess, target, goal, Effort::Default, 3, {attempt, {}});
  EXPECT_TRUE(goal.met(best.excess));
  EXPECT_EQ(rough, 3);
  EXPECT_LE(swept, 3);
}

TEST(ScaleSearch, EndsWhereTheFinestScaleFallsShort) {
  const Motion motion = test::smooth_motion(3);
  const Target target{Target::Kind::Ratio, 25};
  const Goal goal(Original(motion), target, Weighting::Surface, {});
  int tried = 0;
  const auto fall_short = [&](double scale, ClosedLoopWork, const Eigen::VectorXd&) {
    ++tried;
    return Trial{.scale = scale, .excess = -1};
  };
  constexpr double kFinest = 0.5;
  const ScaleGuess guess{.likely = 2, .finest = [] { return kFinest; }};
  const Trial best = search_scale(guess, target, goal, Effort::Default, 3, {fall_short, {}});
  EXPECT_FALSE(goal.met(best.excess));
  EXPECT_LE(tried, 4);
}

}  // namespace
}  // namespace mocapress::scale_search_test
