// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/split_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace mocapress {
namespace {

/// The split that each r_IK would give.
using Curve = std::function<Split(double ratio)>;

/// A motion of 4,000 bytes or more, whose correction takes the more the finer it is.
Curve feet_held_up_to(double ratio) {
  return [ratio](double tried) {
    const double slide = tried <= ratio ? 0.5 : 5.0;
    return Split{tried, 4000 + 4000 / tried + 3 * tried, slide, slide};
  };
}

struct Search {
  SplitSearch search;
  std::vector<double> ratios;
};

Search search_on(const Curve& curve, double slide_without_cm, int finer_steps = 2) {
  Search run{SplitSearch(slide_without_cm, finer_steps), {}};
  while (const auto ratio = run.search.next()) {
    run.ratios.push_back(*ratio);
    run.search.tried(curve(*ratio));
    if (run.ratios.size() > 20) break;
  }
  return run;
}

TEST(SplitSearch, IsNotBeatenByAnyStepOfTwo) {
  for (const double held : {1.0, 2.0, 3.0, 7.0, 16.0, 20.0, 40.0, 64.0, 100.0}) {
    const Curve curve = feet_held_up_to(held);
    const Split best = search_on(curve, 10).search.best();
    EXPECT_LE(best.slide_cm, 1) << held;
    for (double ratio = 1; ratio <= 64; ratio *= 2) {
      const Split fixed = curve(ratio);
      EXPECT_FALSE(fixed.price < best.price && fixed.slide_cm < best.slide_cm)
          << held << " " << ratio;
      EXPECT_TRUE(fixed.slide_cm > 1 || best.price <= fixed.price) << held << " " << ratio;
    }
  }
}

TEST(SplitSearch, LooksBetweenTheStepsOfTwo) {
  EXPECT_NEAR(search_on(feet_held_up_to(24), 10).search.best().ratio, 16 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(search_on(feet_held_up_to(24), 10, 0).search.best().ratio, 16);
}

TEST(SplitSearch, TakesFewEncodes) {
  for (const double held : {1.0, 8.0, 16.0, 24.0, 64.0})
    EXPECT_LE(search_on(feet_held_up_to(held), 10).ratios.size(), 8u) << held;
}

TEST(SplitSearch, TakesAFinerCorrectionWhereThatIsCheaper) {
  const auto cheapest_at_four = [](double ratio) {
    return Split{ratio, 1000 + 500 * std::abs(std::log2(ratio) - 2), 0, 0};
  };
  EXPECT_EQ(search_on(cheapest_at_four, 10).search.best().ratio, 4);
}

TEST(SplitSearch, TakesTheCoarsestWhereThatHoldsByChance) {
  const auto by_chance = [](double ratio) {
    const double slide = ratio == 64 || ratio <= 2 ? 0 : 5;
    return Split{ratio, 5000 / ratio, slide, slide};
  };
  EXPECT_EQ(search_on(by_chance, 10).search.best().ratio, 64);
}

TEST(SplitSearch, TakesTheLeastSlideWhereNothingHolds) {
  const auto sliding = [](double ratio) {
    return Split{ratio, 5000 / ratio, 5 + ratio, 5 + ratio};
  };
  EXPECT_EQ(search_on(sliding, 10).search.best().ratio, 1);
}

TEST(SplitSearch, SpendsNothingOnFeetThatDoNotSlide) {
  const auto still = [](double ratio) { return Split{ratio, 1000 + 100 / ratio, 0, 0}; };
  EXPECT_EQ(search_on(still, 0).search.best().ratio, 64);
}

TEST(SplitSearch, LeavesAMillimetreOfAContactAsItIs) {
  const auto sliding = [](double ratio) {
    return Split{ratio, 5000 / ratio, ratio / 10, ratio / 400};
  };
  EXPECT_EQ(search_on(sliding, 8, 0).search.best().ratio, 32);
}

TEST(SplitSearch, TakesNoSplitThatMissesTheTarget) {
  const auto out_of_reach = [](double ratio) {
    return Split{ratio, ratio < 8 ? std::numeric_limits<double>::infinity() : 1000, ratio / 4,
                 ratio / 4};
  };
  EXPECT_EQ(search_on(out_of_reach, 10).search.best().ratio, 8);
}

}  // namespace
}  // namespace mocapress
