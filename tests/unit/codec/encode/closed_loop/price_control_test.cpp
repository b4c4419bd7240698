// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/price_control.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

/// The part of a sweep's growth that continues in the next sweep at the same price, on typical
/// clips.
constexpr double kContinues = 0.35;

/// A clip whose eps_x answers to the price: by the growth that continues, and by `response`.
struct Sweeps {
  double response;
  double continues = kContinues;
  double log_eps = 0;
  double growth = 0;

  void sweep(double price_factor) {
    growth = continues * growth + response * std::log(price_factor);
    log_eps += growth;
  }
};

/// The distance from `wanted` (both logarithms) after so many controlled sweeps.
double miss_after(int count, double wanted, Sweeps clip) {
  PriceControl control(clip.growth);
  for (int i = 0; i < count; ++i) {
    clip.sweep(control.factor_for(wanted - clip.log_eps));
    control.observe(clip.growth);
  }
  return std::abs(wanted - clip.log_eps);
}

TEST(PriceControl, KeepsThePriceOfAClipAtRest) {
  EXPECT_EQ(PriceControl(0).factor_for(0), 1);
}

TEST(PriceControl, MakesBitsDearerForALargerErrorAndCheaperForASmallerOne) {
  const double dearer = PriceControl(0).factor_for(0.02);
  const double cheaper = PriceControl(0).factor_for(-0.02);
  EXPECT_GT(dearer, 1);
  EXPECT_NEAR(dearer * cheaper, 1, 1e-12);
  EXPECT_GT(PriceControl(0).factor_for(0.04), dearer);
}

TEST(PriceControl, CountsTheGrowthThatContinuesByItself) {
  EXPECT_LT(PriceControl(0.1).factor_for(0), 1);
  EXPECT_NEAR(PriceControl(0.1).factor_for(kContinues * 0.1), 1, 1e-12);
  EXPECT_GT(PriceControl(-0.1).factor_for(0), 1);
}

TEST(PriceControl, NeverChangesThePriceByMuchMoreThanTwofold) {
  for (const double growth : {0.5, 5.0, 500.0}) {
    EXPECT_LT(PriceControl(0).factor_for(growth), 2.1);
    EXPECT_GT(PriceControl(0).factor_for(-growth), 1 / 2.1);
  }
}

TEST(PriceControl, LearnsHowStronglyAClipResponds) {
  const double first = PriceControl(0).factor_for(0.02);
  for (const double response : {0.08, 0.2}) {
    Sweeps clip{response};
    PriceControl control(0);
    clip.sweep(control.factor_for(0.05));
    control.observe(clip.growth);
    const double factor = control.factor_for(0.02 + kContinues * clip.growth);
    EXPECT_NEAR(std::log(factor), 0.02 / response, 1e-9);
    EXPECT_EQ(factor > first, response < 0.15);
  }
}

TEST(PriceControl, LearnsNothingFromASweepAtNearlyTheSamePrice) {
  PriceControl control(0);
  control.factor_for(0.001);
  control.observe(0.2);
  EXPECT_EQ(control.factor_for(0.09), PriceControl(0.2).factor_for(0.09));
}

TEST(PriceControl, ExpectsDearerBitsToRaiseTheErrorEvenAfterAContraryAnswer) {
  PriceControl control(0);
  control.factor_for(0.05);
  control.observe(-0.05);
  EXPECT_GT(control.factor_for(0.02 - kContinues * 0.05), 1);
}

TEST(PriceControl, ComesToRestAtTheWantedErrorWhateverTheResponse) {
  for (const double response : {0.06, 0.1, 0.15, 0.25})
    for (const double continues : {0.2, kContinues, 0.5})
      for (const double wanted : {-0.08, -0.01, 0.03, 0.08})
        EXPECT_LT(miss_after(8, wanted, {response, continues, 0, 0.02}), 0.002)
            << response << ' ' << continues << ' ' << wanted;
}

TEST(PriceControl, ComesToRestAlsoWhereAClipRespondsBeyondItsLimits) {
  for (const double response : {0.04, 0.35})
    for (const double wanted : {-0.05, 0.05})
      EXPECT_LT(miss_after(12, wanted, {response}), 0.002) << response << ' ' << wanted;
}

}  // namespace
}  // namespace mocapress
