// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/library_plot.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/qt/patience.h"
#include "widgets/models/library_filter.h"

namespace mocapress {
namespace {

LibraryEntry entry(const char* path, double ratio, double eps_cm, Sight sight) {
  LibraryEntry made{.path = QString::fromLatin1(path), .frames = 10};
  made.outcome = Outcome{ratio, eps_cm, 2, 1000, true, sight};
  return made;
}

class ALibraryPlot : public testing::Test {
 protected:
  ALibraryPlot() {
    clips_.setEntries({entry("/m/a.bvh", 20, 0.1, Sight::NotVisible),
                       {.path = QStringLiteral("/m/new.bvh"), .frames = 10},
                       entry("/m/b.bvh", 80, 0.6, Sight::Visible)});
    plot_.resize(500, 400);
    plot_.show();
    runDueEvents();
  }

  int points() {
    int count = 0;
    auto* plot = plot_.findChild<QCustomPlot*>();
    for (int i = 0; i + 1 < plot->graphCount(); ++i) count += plot->graph(i)->dataCount();
    return count;  // without the ring
  }

  LibraryModel clips_;
  LibraryFilter filter_{&clips_};
  LibraryPlot plot_{&filter_};
};

TEST_F(ALibraryPlot, AClickOnAPointOpensItsClip) {
  QSignalSpy opened(&plot_, &LibraryPlot::openRequested);
  auto* plot = plot_.findChild<QCustomPlot*>();
  for (const int clip : {0, 2})
    EXPECT_TRUE(plot_.rect().contains(plot_.positionOf(clip))) << "all are in sight";
  QTest::mouseClick(plot, Qt::LeftButton, {}, plot->mapFrom(&plot_, plot_.positionOf(2)));
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(opened[0][0].toInt(), 2);
  QTest::mouseClick(plot, Qt::LeftButton, {}, QPoint(plot->width() / 2, plot->height() / 2));
  EXPECT_EQ(opened.count(), 1) << "there is no point";
}

TEST_F(ALibraryPlot, ShowsWhatTheFilterShowsAndFollowsResults) {
  EXPECT_EQ(points(), 2) << "one is not compressed yet";
  clips_.setEntry(entry("/m/new.bvh", 40, 0.3, Sight::Borderline));
  EXPECT_TRUE(QTest::qWaitFor([&] { return points() == 3; }, kPatience));
  filter_.setShow(LibraryShow::Visible);
  EXPECT_TRUE(QTest::qWaitFor([&] { return points() == 2; }, kPatience));
  plot_.setCurrent(0);  // it is filtered out
  plot_.setCurrent(2);
}

}  // namespace
}  // namespace mocapress
