// SPDX-License-Identifier: MIT
#include "core/report/sight_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Windows of 10 frames in which nothing is seen.
SightTable nothing(int windows) {
  SightTable table{.window_frames = 10};
  table.times_noticed.setZero(windows, test::small_skeleton().joint_count());
  return table;
}

TEST(SightChart, TellsTheWorstOfAllThenTheJointsThatAreSeenMost) {
  const Skeleton skeleton = test::small_skeleton();
  SightTable table = nothing(4);
  table.times_noticed(1, 2) = 1.5F;
  table.times_noticed(3, 4) = 2.5F;
  table.times_noticed(0, 3) = 0.9F;
  const SightChart chart = sight_chart(table, skeleton);
  ASSERT_EQ(chart.size(), 3u);
  EXPECT_EQ(chart[0], (SightLine{"", "0102"}));
  EXPECT_EQ(chart[1], (SightLine{skeleton.joint(4).name, "0002"}));
  EXPECT_EQ(chart[2], (SightLine{skeleton.joint(2).name, "0100"}));
  EXPECT_TRUE(sight_chart(nothing(0), skeleton).empty());
}

TEST(SightChart, StaysSmallAndLosesNoMomentOfALongClip) {
  SightTable table = nothing(10'007);
  table.times_noticed.row(5'003).setConstant(3);
  const SightChart chart = sight_chart(table, test::small_skeleton());
  EXPECT_LE(chart.size(), 9u);
  for (const SightLine& line : chart) {
    EXPECT_LE(line.sights.size(), 240u);
    EXPECT_NE(line.sights.find('2'), std::string::npos);
  }
}

TEST(SightChart, IsDrawnHalfHighWhereItIsBorderline) {
  const std::string svg = draw({{"", "0012"}, {"l<foot", "0002"}}, 4, "walk");
  EXPECT_THAT(svg,
              HasSubstr("class=\"seen1\" x=\"306.0\" y=\"7.5\" width=\"107.0\" height=\"5.5\""));
  EXPECT_THAT(svg,
              HasSubstr("class=\"seen2\" x=\"413.0\" y=\"2.0\" width=\"107.0\" height=\"11.0\""));
  EXPECT_THAT(svg, HasSubstr("l&lt;foot, 3.0 to 4.0 s: visible"));
  EXPECT_THAT(svg, Not(HasSubstr("l<foot")));
}

}  // namespace
}  // namespace mocapress
