// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/count_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mocapress {
namespace {

struct Outcome {
  int count;
  int trials;
};

/// Searches with `excess` as the answer; stops with the last count tried.
template <typename Excess>
Outcome search(CountSearch search, const Excess& excess) {
  Outcome outcome{-1, 0};
  while (!search.done()) {
    outcome = {search.count(), outcome.trials + 1};
    search.tried(excess(search.count()));
  }
  return outcome;
}

TEST(CountSearch, MeetsAPowerLawInFewTrialsFromAnyGuess) {
  for (const int guess : {0, 1, 50, 5000, 100000})
    for (const double wanted : {200.0, 7000.0, 90000.0}) {
      const auto excess = [&](int count) { return 0.9 * std::log((count + 20.0) / wanted); };
      const Outcome found = search(CountSearch(100000, guess, {-0.005, 0.005}, 24), excess);
      EXPECT_LE(std::abs(excess(found.count)), 0.005) << "guess " << guess << " wanted " << wanted;
      EXPECT_LE(found.trials, 12);
    }
}

TEST(CountSearch, EndsBetweenNeighboursWhereNoCountFits) {
  const auto excess = [](int count) { return count < 10 ? -1.0 : 1.0; };
  const Outcome found = search(CountSearch(100, 50, {-0.01, 0.01}, 1000), excess);
  EXPECT_LT(found.trials, 60);
  EXPECT_TRUE(found.count == 9 || found.count == 10);
}

TEST(CountSearch, EndsAtTheLimitsWhereTheTargetIsOutOfReach) {
  const Outcome never_enough =
      search(CountSearch(100, 5, {-0.01, 0.01}, 1000), [](int) { return -3.0; });
  EXPECT_EQ(never_enough.count, 100);
  const Outcome always_too_much =
      search(CountSearch(100, 5, {-0.01, 0.01}, 1000), [](int) { return 3.0; });
  EXPECT_EQ(always_too_much.count, 0);
}

TEST(CountSearch, MakesNoMoreTrialsThanAllowed) {
  int flip = 0;
  const auto noisy = [&](int) { return ++flip % 2 == 0 ? 1.0 : -1.0; };
  EXPECT_LE(search(CountSearch(1000000, 500, {-0.01, 0.01}, 6), noisy).trials, 6);
}

}  // namespace
}  // namespace mocapress
