// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/range_comparison.h"

#include <gtest/gtest.h>

#include <qcustomplot.h>

#include <QAction>
#include <QActionGroup>

#include "core/metrics/distortion.h"
#include "widgets/plots/error_graph.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/timeline.h"

namespace mocapress::range_comparison_test {
namespace {

class ComparisonInARange : public testing::Test {
 protected:
  ComparisonInARange() {
    for (QAction* mode : {&overlay_, &side_by_side_}) {
      mode->setCheckable(true);
      modes_.addAction(mode);
    }
    overlay_.setChecked(true);
    loop_.setCheckable(true);
    quarters_.setCheckable(true);
    playback_.setClip(200, 100);
    timeline_.setContacts({}, {}, 200);
    Eigen::MatrixXf distances = Eigen::MatrixXf::Constant(200, 2, 8);
    distances.middleRows(40, 41).setConstant(0.5F);
    graph_.setErrors(std::make_shared<Distortion>(Distortion{.distances = distances}), 100, {});
  }

  QCPRange seconds() { return graph_.findChild<QCustomPlot*>()->xAxis->range(); }
  double highest() { return graph_.findChild<QCustomPlot*>()->yAxis->range().upper; }

  Playback playback_;
  Timeline timeline_;
  ErrorGraph graph_;
  QAction toggle_;
  QAction overlay_;
  QAction side_by_side_;
  QAction quarters_;
  QAction loop_;
  QActionGroup modes_{nullptr};
  RangeComparison comparison_{
      &playback_, &timeline_, &graph_, &toggle_, {&overlay_, &side_by_side_, &quarters_, &loop_}};
};

TEST_F(ComparisonInARange, IsOfferedOnceThereIsARange) {
  EXPECT_FALSE(toggle_.isEnabled());
  playback_.setRange(std::pair(40, 80));
  EXPECT_TRUE(toggle_.isEnabled());
}

TEST_F(ComparisonInARange, LoopsBothFiguresAndShowsTheErrorsOfTheRangeAlone) {
  playback_.setRange(std::pair(40, 80));
  toggle_.trigger();
  EXPECT_TRUE(playback_.playing());
  EXPECT_TRUE(loop_.isChecked());
  EXPECT_TRUE(side_by_side_.isChecked());
  EXPECT_EQ(playback_.frame(), 40);
  EXPECT_DOUBLE_EQ(seconds().lower, 0.4);
  EXPECT_DOUBLE_EQ(seconds().upper, 0.8);
  EXPECT_LT(highest(), 1) << "the scale is the range's";
  EXPECT_DOUBLE_EQ(timeline_.window().first, 40);
  EXPECT_DOUBLE_EQ(timeline_.window().length, 41);
  playback_.setRange(std::pair(100, 150));
  EXPECT_DOUBLE_EQ(seconds().lower, 1);
  EXPECT_GT(highest(), 8);
}

TEST_F(ComparisonInARange, EndsWithTheRangeAndLeavesAllAsItWas) {
  playback_.setRange(std::pair(40, 80));
  toggle_.trigger();
  playback_.setRange(std::nullopt);
  EXPECT_FALSE(toggle_.isChecked());
  EXPECT_TRUE(overlay_.isChecked());
  EXPECT_FALSE(loop_.isChecked());
  EXPECT_DOUBLE_EQ(seconds().lower, 0);
  EXPECT_DOUBLE_EQ(seconds().upper, 1.99);
  EXPECT_GT(highest(), 8);
  EXPECT_EQ(timeline_.window(), FrameWindow());
}

TEST_F(ComparisonInARange, LeavesTheFourViewsWhileItLasts) {
  quarters_.setChecked(true);
  playback_.setRange(std::pair(40, 80));
  toggle_.trigger();
  EXPECT_FALSE(quarters_.isChecked()) << "they show both figures overlaid";
  EXPECT_TRUE(side_by_side_.isChecked());
  toggle_.trigger();
  EXPECT_TRUE(quarters_.isChecked());
  EXPECT_TRUE(overlay_.isChecked());
}

TEST_F(ComparisonInARange, KeepsAWayOfViewingThatWasChosenBefore) {
  overlay_.setChecked(false);
  modes_.setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
  overlay_.setChecked(false);  // such as the wipe
  playback_.setRange(std::pair(40, 80));
  toggle_.trigger();
  EXPECT_FALSE(side_by_side_.isChecked());
  toggle_.trigger();
  EXPECT_FALSE(overlay_.isChecked());
}

}  // namespace
}  // namespace mocapress::range_comparison_test
