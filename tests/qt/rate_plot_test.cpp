// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/rate_plot.h"

#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QTreeView>

#include "tests/qt/patience.h"
#include "tests/unit/study/study_rows.h"
#include "widgets/models/colours.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/panels/study_results.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

int pixelsOf(const QColor& colour, const QImage& picture) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      count += picture.pixelColor(x, y).rgb() == colour.rgb();
  return count;
}

QColor colourOf(const char* method) {
  return seriesStyle(method, false).colour;
}

std::vector<StudyRow> rows() {
  std::vector<StudyRow> all;
  for (const char* clip : {"walk.bvh", "run.bvh"})
    for (const auto& [method, eps_cm] : {std::pair("standard", 0.1), std::pair("pca", 0.5)})
      for (const double ratio : {5.0, 10.0, 20.0, 40.0})
        all.push_back(
            test::point(clip, method, {Target::Kind::Ratio, ratio}, ratio, eps_cm * ratio / 10));
  return all;
}

/// Puts a widget of a fixed size into a window.
template <typename Widget>
void lay(Widget& widget) {
  widget.resize(700, 500);
  widget.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&widget));
  runDueEvents();
}

void click(RatePlot& plot, const RatePoint& point) {
  auto* canvas = plot.findChild<QCustomPlot*>();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->mapFrom(&plot, plot.positionOf(point)));
}

QStringList labelsOf(const QCPRange& range) {
  LogTicker ticker(QStringLiteral(":1"));
  QVector<double> ticks;
  QVector<QString> labels;
  ticker.generate(range, QLocale::c(), u'g', 3, ticks, nullptr, &labels);
  return QStringList(labels.begin(), labels.end());
}

TEST(LogTicker, LabelsWhatThereIsRoomFor) {
  EXPECT_EQ(labelsOf({20, 50}), QStringList({"20:1", "30:1", "40:1", "50:1"}));
  EXPECT_EQ(labelsOf({18, 105}), QStringList({"20:1", "50:1", "100:1"}));
  EXPECT_EQ(labelsOf({0.9, 2000}), QStringList({"1:1", "10:1", "100:1", "1000:1"}));
  EXPECT_GE(labelsOf({36.2, 38.9}).size(), 3) << "fewer than two digits are in it";
}

TEST(RatePlot, OffersToCopyItsImageWhereItIsClicked) {
  RatePlot plot;
  lay(plot);
  auto* canvas = plot.findChild<QCustomPlot*>();
  QTimer::singleShot(0, &plot, [] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_TRUE(menu);
    menu->actions().front()->trigger();
    menu->close();
  });
  QApplication::clipboard()->clear();
  const QPoint middle = canvas->rect().center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, middle, canvas->mapToGlobal(middle));
  QApplication::sendEvent(canvas, &event);
  EXPECT_EQ(QApplication::clipboard()->pixmap().size(), plot.size());
}

TEST(RatePlot, DrawsEveryCurveInItsColour) {
  RatePlot plot;
  lay(plot);
  plot.setCurves(rateCurves(rows(), "walk.bvh", {}));
  runDueEvents();
  const QImage picture = plot.grab().toImage();
  EXPECT_GT(pixelsOf(colourOf("standard"), picture), 200);
  EXPECT_GT(pixelsOf(colourOf("pca"), picture), 200);
  EXPECT_EQ(pixelsOf(colourOf("annealed"), picture), 0);
}

TEST(RatePlot, TheLabelOfTheResultIsBesideItsMarkFromTheFirstPictureOn) {
  RatePlot plot;
  plot.resize(500, 200);
  plot.setCurves(rateCurves(rows(), "walk.bvh", {}));
  plot.setHere(CurvePoint{15, 0.3});
  plot.grab();
  auto* canvas = plot.findChild<QCustomPlot*>();
  const QCPItemText* label = nullptr;
  for (int i = 0; i < canvas->itemCount(); ++i)
    if (const auto* text = qobject_cast<QCPItemText*>(canvas->item(i)); text && text->visible())
      label = text;
  ASSERT_TRUE(label);
  EXPECT_TRUE(label->positionAlignment() & (Qt::AlignLeft | Qt::AlignRight));
  EXPECT_TRUE(label->positionAlignment() & (Qt::AlignTop | Qt::AlignBottom));
}

TEST(RatePlot, FitsThePanelOfALowWindow) {
  RatePlot plot;
  EXPECT_LE(plot.minimumSizeHint().height(), 180);
}

TEST(RatePlot, AClickOnAPointChoosesItsRow) {
  RatePlot plot;
  lay(plot);
  plot.setCurves(rateCurves(rows(), "run.bvh", {}));
  runDueEvents();
  QSignalSpy chosen(&plot, &RatePlot::pointChosen);
  const RatePoint point = plot.curves()[1].points[2];
  click(plot, point);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), point.row);
  auto* canvas = plot.findChild<QCustomPlot*>();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().bottomRight() - QPoint(60, 90));
  EXPECT_EQ(chosen.count(), 1) << "far from any point";
}

TEST(RatePlot, AxesFollowGrowingCurvesUntilTheUserMovesThem) {
  RatePlot plot;
  lay(plot);
  const auto axis = plot.findChild<QCustomPlot*>()->xAxis;
  const auto some = rows();
  plot.setCurves(rateCurves({some[0], some[1]}, "walk.bvh", {}));
  EXPECT_LT(axis->range().upper, 20);
  plot.setCurves(rateCurves(some, "walk.bvh", {}));
  EXPECT_GT(axis->range().upper, 40);
  emit plot.findChild<QCustomPlot*>()->mouseWheel(nullptr);
  plot.setCurves(rateCurves({some[0], some[1]}, "walk.bvh", {}));
  EXPECT_GT(axis->range().upper, 40);
}

TEST(RatePlot, ItsPictureForPaperIsLightAndHasTheCurvesWhateverThePalette) {
  RatePlot plot;
  QPalette dark(Qt::black);
  plot.setPalette(dark);
  plot.setTitle(QStringLiteral("walk"));
  plot.setCurves(rateCurves(rows(), "walk.bvh", {}));
  const QImage picture = QImage::fromData(plot.png(), "PNG");
  ASSERT_FALSE(picture.isNull());
  EXPECT_EQ(picture.pixelColor(3, 3).rgb(), QColor(Qt::white).rgb());
  EXPECT_GT(pixelsOf(colourOf("pca"), picture), 200);
  const QByteArray pdf = plot.pdf();
  EXPECT_TRUE(pdf.startsWith("%PDF"));
  EXPECT_GT(pdf.size(), 3000);
}

class ResultsTest : public testing::Test {
 protected:
  ResultsTest() {
    lay(results_);
    model_.append(rows());
    results_.setComplete({"walk.bvh", "run.bvh"});
    EXPECT_TRUE(QTest::qWaitFor([this] { return chooser_->count() == 3; }));
  }

  int shownRows() { return results_.table()->model()->rowCount(); }

  StudyRowsModel model_;
  StudyResults results_{&model_};
  QComboBox* chooser_ = results_.findChild<QComboBox*>();
};

using StudyResultsView = ResultsTest;

TEST_F(StudyResultsView, ShowsOneClipOrAll) {
  EXPECT_TRUE(results_.clip().isEmpty());
  EXPECT_EQ(shownRows(), 16);
  EXPECT_TRUE(results_.plot()->curves().front().mean);
  results_.setClip(QStringLiteral("run.bvh"));
  EXPECT_EQ(shownRows(), 8);
  EXPECT_FALSE(results_.plot()->curves().front().mean);
}

TEST_F(StudyResultsView, KeepsTheClipWhileRowsArrive) {
  results_.setClip(QStringLiteral("run.bvh"));
  model_.append({test::point("a third.bvh", "pca", {Target::Kind::Ratio, 5}, 5, 1)});
  ASSERT_TRUE(QTest::qWaitFor([this] { return chooser_->count() == 4; }));
  EXPECT_EQ(results_.clip(), QStringLiteral("run.bvh"));
}

TEST_F(StudyResultsView, APointChosenIsSelectedInTheTable) {
  results_.setClip(QStringLiteral("run.bvh"));
  results_.table()->sortByColumn(StudyRowsModel::Eps, Qt::DescendingOrder);
  runDueEvents();
  QSignalSpy chosen(&results_, &StudyResults::rowChosen);
  const RatePoint point = results_.plot()->curves()[0].points[1];
  click(*results_.plot(), point);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), point.row);
  const QModelIndex current = results_.table()->currentIndex();
  EXPECT_EQ(
      current.siblingAtColumn(StudyRowsModel::Ratio).data().toString(),
      model_.data(model_.index(point.row, StudyRowsModel::Ratio), Qt::DisplayRole).toString());
}

TEST_F(StudyResultsView, SortsByFiguresNotByTheirTexts) {
  results_.table()->sortByColumn(StudyRowsModel::Ratio, Qt::AscendingOrder);
  const QAbstractItemModel* sorted = results_.table()->model();
  double before = 0;
  for (int row = 0; row < sorted->rowCount(); ++row) {
    const double ratio =
        sorted->index(row, StudyRowsModel::Ratio).data(StudyRowsModel::SortRole).toDouble();
    EXPECT_GE(ratio, before);
    before = ratio;
  }
}

TEST_F(StudyResultsView, ADoubleClickedRowIsChosen) {
  QSignalSpy chosen(&results_, &StudyResults::rowChosen);
  const QModelIndex index = results_.table()->model()->index(1, 0);
  const QPoint position = results_.table()->visualRect(index).center();
  QTest::mouseClick(results_.table()->viewport(), Qt::LeftButton, {}, position);
  EXPECT_EQ(chosen.count(), 0);
  QTest::mouseDClick(results_.table()->viewport(), Qt::LeftButton, {}, position);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toInt(), 1);
}

}  // namespace
}  // namespace mocapress
