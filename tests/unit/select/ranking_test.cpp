// SPDX-License-Identifier: MIT
#include "core/select/ranking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

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

class Truncation : public testing::Test {
 protected:
  const Motion motion_ = test::smooth_motion(120);
  const RankedCoefficients ranked_ = rank_coefficients(motion_.clip, Basis::Cubic);
};

TEST_F(Truncation, KeepsTheCountThatWasAskedFor) {
  const StandardOrder standard(ranked_, motion_.skeleton);
  for (const int count : {0, 1, 7, 100, 1000, ranked_.total()}) {
    const Kept per_channel = keep_per_channel(ranked_, count);
    const Kept largest = standard.keep(count);
    EXPECT_EQ(std::accumulate(per_channel.begin(), per_channel.end(), 0), count);
    EXPECT_EQ(std::accumulate(largest.begin(), largest.end(), 0), count);
  }
}

TEST_F(Truncation, PerChannelKeepsAsManyFromEach) {
  const Kept kept = keep_per_channel(ranked_, 50);
  const auto [fewest, most] = std::minmax_element(kept.begin(), kept.end());
  EXPECT_LE(*most - *fewest, 1);
}

TEST_F(Truncation, StandardKeepsNothingSmallerThanWhatItDrops) {
  const std::vector<double> scales = channel_scales(motion_.skeleton);
  const Kept kept = StandardOrder(ranked_, motion_.skeleton).keep(200);
  double smallest_kept = 1e300;
  double largest_dropped = 0;
  for (int c = 0; c < ranked_.channels(); ++c)
    for (int i = 0; i < ranked_.per_channel(); ++i) {
      const int at =
          ranked_.by_importance[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)];
      const double scaled = ranked_.importance(at, c) * scales[static_cast<std::size_t>(c)];
      if (i < kept[static_cast<std::size_t>(c)])
        smallest_kept = std::min(smallest_kept, scaled);
      else
        largest_dropped = std::max(largest_dropped, scaled);
    }
  EXPECT_GE(smallest_kept, largest_dropped);
}

TEST_F(Truncation, ScalesAnglesByTheBoneTheyDriveAndTranslationsByOne) {
  const std::vector<double> scales = channel_scales(motion_.skeleton);
  EXPECT_EQ(scales[0], 1);
  EXPECT_EQ(scales[3], 20);  // the root drives the spine's 20 cm
  const int lower = motion_.skeleton.first_channel(motion_.skeleton.find("llower"));
  EXPECT_EQ(scales[static_cast<std::size_t>(lower)], 25);
}

TEST(ChannelScales, AJointThatDrivesNoLengthCountsAsTheLongest) {
  Skeleton skeleton;
  skeleton.add({.name = "root", .channels = {ChannelKind::RotationX}});  // as in ASF
  skeleton.add({.name = "hip", .parent = 0, .channels = {ChannelKind::RotationX}});
  skeleton.add({.name = "knee", .parent = 1, .offset = {0, -42, 0}});
  EXPECT_EQ(channel_scales(skeleton), (std::vector<double>{42, 42}));
}

}  // namespace
}  // namespace mocapress
