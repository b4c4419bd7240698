// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/encode_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(EncodeEstimate, ShareOfAnAnnealingGrowsFromZeroToOneInAPass) {
  EncodeProgress state;
  EXPECT_DOUBLE_EQ(passProgress(state), 0);
  state.first_step = 64;
  double before = -1;
  for (const int step : {64, 32, 16, 8, 4, 2, 1, 0}) {
    state.step = step;
    EXPECT_GT(passProgress(state), before);
    before = passProgress(state);
  }
  EXPECT_DOUBLE_EQ(before, 1);
}

TEST(EncodeEstimate, GrowsWithEveryReportAndStaysBelowOne) {
  const Encoder encoder(test::smooth_motion(400));
  for (const Method method : {Method::Annealed, Method::ClosedLoop})
    for (const Target& target :
         {Target{Target::Kind::Ratio, 15}, Target{Target::Kind::MaxError, 1.5}}) {
      const EncodeSettings options{.method = method, .target = target};
      EncodeEstimate estimate(options);
      std::vector<double> shares;
      encoder.encode(options, [&](const EncodeProgress& state) {
        estimate.add(state, 0.01 * static_cast<double>(shares.size() + 1));
        shares.push_back(estimate.share());
        return true;
      });
      ASSERT_GT(shares.size(), 3u);
      EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
      EXPECT_LT(shares.front(), 0.5);
      EXPECT_GT(shares.back(), shares.front());
      EXPECT_LT(shares.back(), 1);
    }
}

TEST(EncodeEstimate, EstimatesTheTimeLeftFromTheTimePassed) {
  EncodeEstimate estimate({.method = Method::ClosedLoop});
  estimate.add({.pass = 1, .iteration = 1}, 0.2);
  EXPECT_FALSE(estimate.secondsLeft()) << "too early to tell";
  estimate.add({.pass = 2, .iteration = 1}, 4);
  ASSERT_TRUE(estimate.secondsLeft());
  EXPECT_NEAR(*estimate.secondsLeft(), 4 * (1 - estimate.share()) / estimate.share(), 1e-9);
}

TEST(EncodeEstimate, LearnsThatASegmentedClipTakesMoreSweepsAPass) {
  EncodeEstimate estimate({.method = Method::ClosedLoop, .target = {Target::Kind::MaxError, 1}});
  for (int sweep = 1; sweep <= 200; ++sweep) estimate.add({.pass = 1, .iteration = sweep}, 1);
  estimate.add({.pass = 2, .iteration = 1}, 1);
  const double begins = estimate.share();
  estimate.add({.pass = 2, .iteration = 100}, 1);
  const double middle = estimate.share();
  estimate.add({.pass = 2, .iteration = 200}, 1);
  EXPECT_GT(middle - begins, 0.3 * (estimate.share() - begins));
  EXPECT_LT(middle - begins, 0.7 * (estimate.share() - begins));
}

}  // namespace
}  // namespace mocapress
