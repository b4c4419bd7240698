// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/goal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/metrics/rate.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using Kind = Target::Kind;

constexpr Kind kKinds[] = {Kind::Ratio, Kind::CoefficientRatio, Kind::Size,
                           Kind::Error, Kind::MaxError,         Kind::Visibility};

class GoalTest : public testing::Test {
 protected:
  Goal goal(Target target, Weighting weighting = Weighting::BoneEnds) const {
    return {Original(motion_), target, weighting, {}};
  }

  /// The motion with its root moved along x by `cm(t)` at frame t.
  template <typename Cm>
  Clip shifted(const Cm& cm) const {
    Clip clip = motion_.clip;
    for (int t = 0; t < clip.frames(); ++t) clip.channels(t, 0) += cm(t);
    return clip;
  }

  /// The motion with a share of its coefficients, which takes no search.
  CompressedClip rough() const {
    return test::segmented_clip(motion_, SegmentLayout::whole(motion_.clip.frames()));
  }

  const Motion motion_ = test::smooth_motion(240);
};

TEST_F(GoalTest, CountsBytesWithoutDecoding) {
  const auto refuse = []() -> Clip {
    ADD_FAILURE() << "decoded";
    return {};
  };
  EXPECT_EQ(goal({Kind::Size, 100}).achieved(700, refuse), 700);
  EXPECT_EQ(goal({Kind::Ratio, 10}).achieved(700, refuse), compression_ratio(motion_.clip, 700));
  EXPECT_EQ(goal({Kind::CoefficientRatio, 30}).achieved(700, refuse), 30);
}

TEST_F(GoalTest, MeasuresErrorsOnTheDecodedClip) {
  const auto jump = [&] { return shifted([](int t) { return t == 100 ? 3.0 : 0.0; }); };
  const auto steady = [&] { return shifted([](int) { return 2.0; }); };
  EXPECT_NEAR(goal({Kind::Error, 1}).achieved(0, steady), 2, 1e-5);
  EXPECT_NEAR(goal({Kind::Error, 1}).achieved(0, jump), 3 / std::sqrt(240), 1e-5);
  EXPECT_NEAR(goal({Kind::MaxError, 1}).achieved(0, jump), 3, 1e-5);
  const auto unchanged = [&] { return motion_.clip; };
  EXPECT_LT(goal({Kind::Visibility, 1}).achieved(0, unchanged), 1e-6);
  EXPECT_GT(goal({Kind::Visibility, 1}).achieved(0, jump), 0.1);
}

TEST_F(GoalTest, MeasuresACodedClipLikeTheMotionItDecodesTo) {
  const CompressedClip clip = rough();
  const double worst = goal({Kind::MaxError, 1}).worst_of_frames(clip).maxCoeff();
  EXPECT_NEAR(goal({Kind::MaxError, 1}).achieved(clip), worst, 1e-4 * worst);
  EXPECT_LT(goal({Kind::Error, 1}).achieved(clip), worst);
  EXPECT_EQ(goal({Kind::Size, 1}).achieved(clip), static_cast<double>(clip.motion_bytes()));
}

TEST_F(GoalTest, ExcessGrowsWithTheNumberOfCoefficientsAndIsZeroAtTheTarget) {
  for (const Kind kind : kKinds) {
    const Goal wanted = goal({kind, 8});
    EXPECT_EQ(wanted.excess(8), 0);
    // More coefficients make a file larger, and its ratio and its errors smaller.
    const double fewer = kind == Kind::Size ? 4 : 16;
    const double more = kind == Kind::Size ? 16 : 4;
    EXPECT_LT(wanted.excess(fewer), 0) << name(kind);
    EXPECT_GT(wanted.excess(more), 0) << name(kind);
  }
}

TEST_F(GoalTest, ExcessOfAPerfectReconstructionIsFinite) {
  EXPECT_TRUE(std::isfinite(goal({Kind::Error, 0.1}).excess(0)));
  EXPECT_TRUE(std::isfinite(goal({Kind::MaxError, 0}).excess(0)));
}

TEST_F(GoalTest, ARatioIsMetWithinTwoPercentAndABoundOnlyOnItsOwnSide) {
  const auto meets = [&](Kind kind, double achieved) {
    const Goal wanted = goal({kind, 100});
    return wanted.met(wanted.excess(achieved));
  };
  for (const double ratio : {98.1, 100.0, 101.9}) EXPECT_TRUE(meets(Kind::Ratio, ratio));
  for (const double ratio : {97.9, 102.1}) EXPECT_FALSE(meets(Kind::Ratio, ratio));
  for (const Kind bound : {Kind::Size, Kind::Error, Kind::MaxError, Kind::Visibility}) {
    EXPECT_TRUE(meets(bound, 100)) << name(bound);
    EXPECT_TRUE(meets(bound, 50)) << name(bound);
    EXPECT_FALSE(meets(bound, 100.01)) << name(bound);
  }
}

TEST_F(GoalTest, AnySearchThatEndsInItsWindowMeetsTheTarget) {
  for (const Kind kind : kKinds) {
    const Goal wanted = goal({kind, 8});
    const auto [low, high] = wanted.window();
    EXPECT_LT(low, high);
    EXPECT_TRUE(wanted.met(low)) << name(kind);
    EXPECT_TRUE(wanted.met(high)) << name(kind);
  }
}

TEST_F(GoalTest, PrefersAnOutcomeThatMeetsTheTargetThenTheNearerOne) {
  const Goal bound = goal({Kind::Error, 1});
  EXPECT_TRUE(bound.better(0.5, -0.01));
  EXPECT_FALSE(bound.better(-0.01, 0.5));
  EXPECT_TRUE(bound.better(0.1, 0.5));
  EXPECT_TRUE(bound.better(-0.1, -0.5));
  EXPECT_FALSE(bound.better(0.1, 0.1));
}

TEST_F(GoalTest, RefusesAMissedTargetAndSaysWhatIsNearest) {
  const Goal wanted = goal({Kind::Error, 0.25});
  EXPECT_NO_THROW(wanted.require_met(wanted.excess(0.2), 0.2, false));
  try {
    wanted.require_met(wanted.excess(0.5), 0.5, false);
    FAIL();
  } catch (const TargetMissed& missed) {
    EXPECT_THAT(missed.what(), testing::HasSubstr("0.25"));
    EXPECT_THAT(missed.what(), testing::HasSubstr("0.5"));
  }
}

TEST_F(GoalTest, ForgivesAHigherRatioWhenEveryCoefficientIsKept) {
  const Goal wanted = goal({Kind::Ratio, 2});
  const double excess = wanted.excess(3);
  EXPECT_NO_THROW(wanted.require_met(excess, 3, true));
  EXPECT_THROW(wanted.require_met(excess, 3, false), TargetMissed);
  EXPECT_THROW(wanted.require_met(wanted.excess(1), 1, true), TargetMissed);
}

TEST_F(GoalTest, GuessesTheSameCoefficientRatioFromASizeAndFromItsRatio) {
  EXPECT_EQ(goal({Kind::CoefficientRatio, 30}).likely_coefficient_ratio(), 30);
  const double bytes = 500;
  const double ratio = compression_ratio(motion_.clip, 500);
  EXPECT_NEAR(goal({Kind::Size, bytes}).likely_coefficient_ratio(),
              goal({Kind::Ratio, ratio}).likely_coefficient_ratio(), 1e-9);
  EXPECT_GT(goal({Kind::Ratio, 2 * ratio}).likely_coefficient_ratio(),
            goal({Kind::Ratio, ratio}).likely_coefficient_ratio());
}

TEST_F(GoalTest, RaisesOnlyWeightsOfFramesNearOrBeyondAHardMaximumTheWorstMost) {
  const CompressedClip clip = rough();
  const Eigen::VectorXd errors = goal({Kind::MaxError, 1}).worst_of_frames(clip);
  const double bound = 0.5 * errors.maxCoeff();
  const Goal wanted = goal({Kind::MaxError, bound});
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(errors.size());
  wanted.raise_where_exceeded(clip, weights);
  Eigen::Index worst = 0;
  errors.maxCoeff(&worst);
  EXPECT_EQ(weights(worst), weights.maxCoeff());
  int untouched = 0;
  for (Eigen::Index t = 0; t < errors.size(); ++t) {
    if (errors(t) > bound) {
      EXPECT_GT(weights(t), 1) << t;
    } else if (errors(t) < 0.85 * bound) {
      EXPECT_EQ(weights(t), 1) << t;
    }
    untouched += weights(t) == 1;
  }
  EXPECT_GT(untouched, 0);
  const Eigen::VectorXd once = weights;
  wanted.raise_where_exceeded(clip, weights);
  EXPECT_GT(weights(worst), once(worst));
}

TEST_F(GoalTest, RaisesWeightsOfWholeWindowsWhereAnErrorIsNoticed) {
  const CompressedClip clip = rough();
  const SightTable table = goal({Kind::Visibility, 1}).seen(clip).table;
  const double worst = static_cast<double>(table.times_noticed.maxCoeff());
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(clip.frames);
  goal({Kind::Visibility, 0.5 * worst}).raise_where_exceeded(clip, weights);
  EXPECT_GT(weights.maxCoeff(), 1);
  for (int t = 1; t < clip.frames; ++t)
    if (table.window_of(t) == table.window_of(t - 1)) {
      EXPECT_EQ(weights(t), weights(t - 1)) << t;
    }
}

}  // namespace
}  // namespace mocapress
