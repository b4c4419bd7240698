// SPDX-License-Identifier: MIT
#include "core/select/annealing.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numeric>

#include "core/metrics/distortion.h"
#include "core/select/ranking.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class Annealing : public testing::Test {
 protected:
  Clip decoded(const Kept& kept) const {
    Clip clip = motion_.clip;
    for (int c = 0; c < ranked_.channels(); ++c)
      clip.channels.col(c) = synthesise(ranked_, c, 0, kept[static_cast<std::size_t>(c)]);
    return clip;
  }
  double exact(const Kept& kept) const {
    return measure(motion_.skeleton, motion_.clip, decoded(kept)).eps_bone_ends;
  }

  const Motion motion_ = test::smooth_motion(300);
  const RankedCoefficients ranked_ = rank_coefficients(motion_.clip, Basis::Cubic);
  const ErrorModel model_{motion_.skeleton, motion_.clip, Weighting::BoneEnds};
  const Kept start_ = StandardOrder(ranked_, motion_.skeleton).keep(ranked_.total() / 12);
};

TEST_F(Annealing, KeepsTheNumberOfCoefficients) {
  const AnnealingReport report = anneal(ranked_, model_, start_);
  EXPECT_EQ(std::accumulate(report.kept.begin(), report.kept.end(), 0),
            std::accumulate(start_.begin(), start_.end(), 0));
  for (const int kept : report.kept) {
    EXPECT_GE(kept, 0);
    EXPECT_LE(kept, ranked_.per_channel());
  }
}

TEST_F(Annealing, IsNeverWorseThanItsStartAndBetterHere) {
  const AnnealingReport report = anneal(ranked_, model_, start_);
  EXPECT_LE(report.eps_cm, report.first_eps_cm);
  EXPECT_LT(exact(report.kept), 0.95 * exact(start_));
}

TEST_F(Annealing, ReportsTheErrorThatForwardKinematicsFinds) {
  const AnnealingReport report = anneal(ranked_, model_, start_);
  ASSERT_LT(report.eps_cm, 1.5);
  EXPECT_NEAR(report.eps_cm / exact(report.kept), 1, 0.02);
}

TEST_F(Annealing, ErrorNeverRisesFromOneIterationToTheNext) {
  double last = 1e300;
  anneal(ranked_, model_, start_, 1, [&](const AnnealingProgress& progress) {
    EXPECT_LE(progress.eps_cm, last * (1 + 4e-6));  // the model computes in floats
    last = progress.eps_cm;
    return true;
  });
}

TEST_F(Annealing, EveryMoveIsTheBestThatExactEvaluationFinds) {
  // One iteration at a time: the coefficients taken from a channel went where the exact error is
  // lowest.
  Kept before = start_;
  for (int seed = 1; seed <= 8; ++seed) {
    const AnnealingReport report = anneal(ranked_, model_, before, static_cast<std::uint64_t>(seed),
                                          [](const AnnealingProgress&) { return false; });
    int from = -1;
    int moved = 0;
    for (std::size_t c = 0; c < before.size(); ++c)
      if (report.kept[c] < before[c]) {
        from = static_cast<int>(c);
        moved = before[c] - report.kept[c];
      }
    if (from < 0) continue;  // the drawn channel kept its coefficients
    double best = 1e300;
    for (std::size_t c = 0; c < before.size(); ++c) {
      Kept candidate = before;
      candidate[static_cast<std::size_t>(from)] -= moved;
      candidate[c] += moved;
      if (candidate[c] <= ranked_.per_channel()) best = std::min(best, exact(candidate));
    }
    EXPECT_LE(exact(report.kept), 1.02 * best);
    before = report.kept;
  }
}

TEST_F(Annealing, IsTheSameForTheSameSeedOnAnyNumberOfThreads) {
  const AnnealingReport many = anneal(ranked_, model_, start_, 5);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const AnnealingReport single = anneal(ranked_, model_, start_, 5);
  EXPECT_EQ(many.kept, single.kept);
  EXPECT_EQ(many.iterations, single.iterations);
  EXPECT_EQ(many.eps_cm, single.eps_cm);
}

TEST_F(Annealing, StopsWhenToldAndSaysSo) {
  const AnnealingReport report = anneal(ranked_, model_, start_, 1,
                                        [](const AnnealingProgress& p) { return p.iteration < 7; });
  EXPECT_EQ(report.iterations, 7);
  EXPECT_FALSE(report.complete);
}

TEST_F(Annealing, EndsAtOnceWithoutCoefficients) {
  const Kept nothing(start_.size(), 0);
  const AnnealingReport report = anneal(ranked_, model_, nothing);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(report.kept, nothing);
  EXPECT_TRUE(report.complete);
}

}  // namespace
}  // namespace mocapress
