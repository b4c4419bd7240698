// SPDX-License-Identifier: MIT
#include "core/batch/time_left.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

/// Three clips of 100, 100 and 800 bytes, of which the first two are done.
BatchCounts at_the_long_one(double share) {
  return {.clips = 3, .done = 2, .bytes = 1000, .bytes_done = 200, .bytes_under_way = 800 * share};
}

TEST(TimeLeft, IsUnsetUntilAClipWasWorkedOnToItsEnd) {
  TimeLeft left;
  left.update({.clips = 3, .bytes = 1000, .bytes_under_way = 50}, 1);
  EXPECT_FALSE(left.seconds());
  left.update(
      {.clips = 3, .done = 1, .kept = 1, .bytes = 1000, .bytes_done = 100, .bytes_kept = 100}, 1);
  EXPECT_FALSE(left.seconds());
  left.update(
      {.clips = 3, .done = 2, .kept = 1, .bytes = 1000, .bytes_done = 200, .bytes_kept = 100}, 2);
  EXPECT_EQ(left.seconds(), 16);
}

TEST(TimeLeft, FallsWithTheProgressOfTheLastLongClip) {
  TimeLeft left;
  left.update(at_the_long_one(0), 2);
  EXPECT_EQ(left.seconds(), 8);
  left.update(at_the_long_one(0.25), 4);
  EXPECT_EQ(left.seconds(), 6);
  left.update(at_the_long_one(0.75), 8);
  EXPECT_EQ(left.seconds(), 2);
}

TEST(TimeLeft, NeverGrowsWhileALongClipSeemsToStandStill) {
  TimeLeft left;
  left.update(at_the_long_one(0.5), 6);
  EXPECT_EQ(left.seconds(), 4);
  left.update(at_the_long_one(0.5), 60);
  EXPECT_EQ(left.seconds(), 4);
}

TEST(TimeLeft, IsToldAnewByEveryClipThatEnds) {
  TimeLeft left;
  left.update({.clips = 3, .done = 1, .bytes = 1000, .bytes_done = 100}, 1);
  EXPECT_EQ(left.seconds(), 9);
  left.update(at_the_long_one(0), 10);
  EXPECT_EQ(left.seconds(), 40);
  left.update({.clips = 3, .done = 3, .bytes = 1000, .bytes_done = 1000}, 50);
  EXPECT_EQ(left.seconds(), 0);
}

}  // namespace
}  // namespace mocapress
