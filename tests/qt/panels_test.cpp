// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "widgets/panels/annealing_panel.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/result_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/panels/warnings_panel.h"
#include "widgets/plots/error_graph.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/transport_bar.h"

namespace mocapress {
namespace {

TEST(TargetControl, SliderAndNumberSayTheSame) {
  TargetControl control;
  std::vector<Target> targets;
  QObject::connect(&control, &TargetControl::targetChanged,
                   [&](const Target& target) { targets.push_back(target); });
  auto* number = control.findChild<QDoubleSpinBox*>();
  control.slider()->setValue(500);
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_NEAR(targets[0].value, 20, 1e-6);
  EXPECT_NEAR(number->value(), 20, 0.05);
  number->setValue(200);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(control.slider()->value(), control.slider()->maximum());
}

TEST(TargetControl, RemembersTheValuesOfTheOtherKinds) {
  TargetControl control;
  control.setTarget({Target::Kind::Ratio, 33});
  auto* kind = control.findChild<QComboBox*>();
  const auto choose = [&](int index) {
    kind->setCurrentIndex(index);
    emit kind->activated(index);
  };
  std::vector<Target::Kind> kinds;
  for (int index = 0; index < kind->count(); ++index) {
    choose(index);
    kinds.push_back(control.target().kind);
    EXPECT_GT(control.target().value, 0);
  }
  using enum Target::Kind;
  EXPECT_EQ(kinds, (std::vector{Ratio, Size, Error, MaxError}));
  choose(0);
  EXPECT_EQ(control.target().kind, Target::Kind::Ratio);
  EXPECT_DOUBLE_EQ(control.target().value, 33);
}

TEST(CompressionPanel, ShowsOptionsSilentlyAndTellsOfChoices) {
  CompressionPanel panel;
  std::vector<EncodeOptions> chosen;
  QObject::connect(&panel, &CompressionPanel::optionsChanged,
                   [&](const EncodeOptions& options) { chosen.push_back(options); });
  EncodeOptions options;
  options.method = Method::Standard;
  options.coding = Coding::Rle16;
  options.seed = 9;
  options.target.value = 50;
  panel.setOptions(options);
  EXPECT_TRUE(chosen.empty());
  panel.target()->slider()->setValue(0);
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(chosen[0].method, Method::Standard);
  EXPECT_EQ(chosen[0].coding, Coding::Rle16);
  EXPECT_EQ(chosen[0].seed, 9U);
  EXPECT_NEAR(chosen[0].target.value, 2, 1e-9);
}

TEST(CompressionPanel, EveryControlHasANameAndAnExplanation) {
  CompressionPanel panel;
  QWidgetList controls;
  for (QWidget* control : panel.findChildren<QComboBox*>()) controls << control;
  for (QWidget* control : panel.findChildren<QAbstractSpinBox*>()) controls << control;
  for (QWidget* control : panel.findChildren<QSlider*>()) controls << control;
  EXPECT_EQ(controls.size(), 11);
  for (const QWidget* control : controls) {
    EXPECT_FALSE(control->accessibleName().isEmpty());
    EXPECT_FALSE(control->toolTip().isEmpty()) << control->accessibleName().toStdString();
  }
}

TEST(ResultPanel, ShowsDashesForWhatIsNotKnown) {
  ResultPanel panel;
  ResultFigures figures;
  figures.ratio = 12.34;
  figures.eps_cm = 0.456;
  panel.setFigures(figures);
  QStringList texts;
  for (const QLabel* label : panel.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("12.3 : 1"))) << texts.join(u'|').toStdString();
  EXPECT_TRUE(texts.contains(QStringLiteral("0.46 cm")));
  EXPECT_EQ(texts.count(QStringLiteral("–")), 6);
}

TEST(AnnealingPanel, ProgressRunsFromNoneToAllOfAPass) {
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

TEST(AnnealingPanel, CanBeCancelledOnlyWhileItRuns) {
  AnnealingPanel panel;
  auto* cancel = panel.findChild<QPushButton*>();
  EXPECT_FALSE(cancel->isEnabled());
  panel.setRunning(true);
  panel.append({{0, 0, 8, 8, 1.0}, {0, 1, 8, 8, 0.9}, {1, 0, 8, 8, 1.1}});
  const QSignalSpy cancelled(&panel, &AnnealingPanel::cancelRequested);
  cancel->click();
  EXPECT_EQ(cancelled.count(), 1);
  panel.setRunning(false);
  EXPECT_FALSE(cancel->isEnabled());
}

TEST(MessageBar, OffersARemedyOnceAndLeavesWithIt) {
  QWidget window;
  MessageBar bar(&window);
  window.show();
  QAction remedy(QStringLiteral("Choose Skeleton…"));
  const QSignalSpy asked(&remedy, &QAction::triggered);
  bar.showError(QStringLiteral("no skeleton"), &remedy);
  EXPECT_TRUE(bar.isVisible());
  EXPECT_EQ(bar.text(), QStringLiteral("no skeleton"));
  for (auto* button : bar.findChildren<QToolButton*>())
    if (button->defaultAction() == &remedy) button->click();
  EXPECT_EQ(asked.count(), 1);
  EXPECT_FALSE(bar.isVisible());
  bar.showError(QStringLiteral("another"));
  for (const auto* button : bar.findChildren<QToolButton*>())
    EXPECT_NE(button->defaultAction(), &remedy);
}

TEST(WarningsPanel, ShowsItselfOnlyWhereThereAreWarnings) {
  QWidget window;
  WarningsPanel panel(&window);
  window.show();
  panel.setWarnings({{"a.bvh", 3, "guessed"}, {"a.bvh", 0, "repaired"}});
  EXPECT_TRUE(panel.isVisible());
  panel.setWarnings({});
  EXPECT_FALSE(panel.isVisible());
}

TEST(ErrorGraph, AClickSeeksToTheFrameThere) {
  ErrorGraph graph;
  graph.resize(600, 300);
  graph.show();
  auto distances = std::make_shared<Eigen::MatrixXf>(Eigen::MatrixXf::Random(101, 3).cwiseAbs());
  graph.setDistances(distances, 100, {{QStringLiteral("a"), Qt::red, 0}});
  graph.setCurves({{QStringLiteral("a"), Qt::red, 0}, {QStringLiteral("b"), Qt::blue, 2}});
  QTest::qWait(50);
  auto* plot = graph.findChild<QCustomPlot*>();
  EXPECT_EQ(plot->graphCount(), 3);  // and the worst of all
  const QSignalSpy sought(&graph, &ErrorGraph::seekRequested);
  const int x = static_cast<int>(plot->xAxis->coordToPixel(0.4));
  QTest::mouseClick(plot, Qt::LeftButton, {}, {x, plot->height() / 2});
  ASSERT_GE(sought.count(), 1);
  EXPECT_NEAR(sought[0][0].toInt(), 40, 1);
}

TEST(ErrorGraph, WithoutDistancesIgnoresClicks) {
  ErrorGraph graph;
  graph.show();
  const QSignalSpy sought(&graph, &ErrorGraph::seekRequested);
  QTest::mouseClick(graph.findChild<QCustomPlot*>(), Qt::LeftButton, {}, {80, 80});
  EXPECT_EQ(sought.count(), 0);
}

TEST(TransportBar, ScrubbingSeeksAndPlayingMovesTheSlider) {
  Playback playback;
  QObject owner;
  TransportBar bar(&playback, TransportBar::makeActions(&playback, &owner));
  playback.setClip(50, 100);
  auto* scrub = bar.findChild<QSlider*>();
  EXPECT_EQ(scrub->maximum(), 49);
  scrub->setValue(20);
  EXPECT_EQ(playback.frame(), 20);
  playback.seek(30);
  EXPECT_EQ(scrub->value(), 30);
}

}  // namespace
}  // namespace mocapress
