// SPDX-License-Identifier: MIT
#include "core/select/ranking.h"

#include <gtest/gtest.h>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Ranking, OrdersEachChannelByImportance) {
  const auto ranked = rank_coefficients(test::smooth_motion(150).clip, Basis::Cubic);
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto& order = ranked.by_importance[static_cast<std::size_t>(c)];
    for (std::size_t i = 1; i < order.size(); ++i)
      EXPECT_GE(ranked.importance(order[i - 1], c), ranked.importance(order[i], c));
  }
}

TEST(Ranking, KeepingEverythingRestoresTheSignal) {
  const Motion motion = test::smooth_motion(150);
  const auto ranked = rank_coefficients(motion.clip, Basis::Cubic);
  for (int c = 0; c < ranked.channels(); ++c)
    EXPECT_TRUE(synthesise(ranked, c, 0, 150).isApprox(motion.clip.channels.col(c), 1e-12));
}

TEST(Ranking, SynthesisOfPartsAddsUp) {
  const auto ranked = rank_coefficients(test::smooth_motion(90).clip, Basis::Cubic);
  const Eigen::VectorXd whole = synthesise(ranked, 4, 0, 30);
  const Eigen::VectorXd parts = synthesise(ranked, 4, 0, 11) + synthesise(ranked, 4, 11, 30);
  EXPECT_TRUE(whole.isApprox(parts, 1e-12));
}

TEST(Ranking, TruncationKeepsJustTheLargest) {
  const auto ranked = rank_coefficients(test::smooth_motion(64).clip, Basis::Cubic);
  const Kept kept(static_cast<std::size_t>(ranked.channels()), 5);
  const Eigen::MatrixXd truncated = truncate(ranked, kept);
  for (int c = 0; c < ranked.channels(); ++c) {
    EXPECT_EQ((truncated.col(c).array() != 0).count(), 5);
    for (int i = 0; i < 5; ++i) {
      const int kept_one =
          ranked.by_importance[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)];
      EXPECT_EQ(truncated(kept_one, c), ranked.values(kept_one, c));
    }
  }
}

TEST(Ranking, EachFurtherCoefficientLowersTheErrorOfItsChannelInTheLongRun) {
  const Motion motion = test::smooth_motion(200);
  const auto ranked = rank_coefficients(motion.clip, Basis::Cubic);
  for (int c = 0; c < ranked.channels(); ++c) {
    const auto error = [&](int kept) {
      return (synthesise(ranked, c, 0, kept) - motion.clip.channels.col(c)).norm();
    };
    EXPECT_LT(error(40), error(10));
    EXPECT_LT(error(10), error(1));
  }
}

}  // namespace
}  // namespace mocapress
