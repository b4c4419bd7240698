// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QTreeView>
#include <cmath>

#include "app/studio/window/theme.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/joint_error_model.h"
#include "widgets/panels/annealing_panel.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/number_fields.h"
#include "widgets/panels/result_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/plots/error_graph.h"
#include "widgets/timeline/playback.h"
#include "widgets/timeline/transport_bar.h"

namespace mocapress {
namespace {

/// Types a text and Enter.
void type(NumberBox* box, const QString& text) {
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

void choose(TargetControl& control, Target::Kind kind) {
  const int index = control.kind()->findData(static_cast<int>(kind));
  control.kind()->setCurrentIndex(index);
  emit control.kind()->activated(index);
}

TEST(TargetControl, SliderAndNumberSayTheSame) {
  TargetControl control;
  std::vector<Target> targets;
  QObject::connect(&control, &TargetControl::targetChanged,
                   [&](const Target& target) { targets.push_back(target); });
  control.slider()->setValue(500);
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_NEAR(targets[0].value, std::sqrt(2 * 1000), 0.05);
  EXPECT_NEAR(control.number()->value(), targets[0].value, 0.05);
  control.number()->setValue(1000);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(control.slider()->value(), control.slider()->maximum());
}

TEST(TargetControl, TakesWhatIsTypedHoweverLargeOrSmall) {
  TargetControl control;
  for (const auto& [kind, texts] :
       {std::pair(Target::Kind::Ratio, QStringList{"264", "1.05", "1500", "25000", "0.5"}),
        std::pair(Target::Kind::Error, QStringList{"0.0004", "0.0123", "75"}),
        std::pair(Target::Kind::MaxError, QStringList{"0.005", "120"}),
        std::pair(Target::Kind::Size, QStringList{"7", "123456789"})}) {
    choose(control, kind);
    for (const QString& text : texts) {
      type(control.number(), text);
      const double unit =
          kind == Target::Kind::Ratio || kind == Target::Kind::Size ? 1 : 0.1;  // cm
      EXPECT_DOUBLE_EQ(control.target().value, unit * text.toDouble()) << qPrintable(text);
      EXPECT_TRUE(control.number()->text().startsWith(text))
          << qPrintable(control.number()->text());
    }
  }
}

TEST(TargetControl, ErrorsAreInMillimetresAndTheSameNumbersAsOnTheCommandLine) {
  TargetControl control;
  control.setTarget({Target::Kind::Error, 0.25});
  EXPECT_EQ(control.number()->text(), QStringLiteral("2.5 mm"));
  for (const auto& [text, cm] : {std::pair("6.6", 0.66), {"0.7", 0.07}, {"12.3", 1.23}}) {
    type(control.number(), QString::fromLatin1(text));
    EXPECT_EQ(control.target().value, cm) << text;
  }
}

TEST(TargetControl, SaysWhatIsWrongBesideTheNumberAndLeavesIt) {
  TargetControl control;
  type(control.number(), QStringLiteral("5000"));
  EXPECT_TRUE(control.trouble().isEmpty());
  control.setTrouble(QStringLiteral("Out of reach"), QStringLiteral("the nearest is 312"));
  EXPECT_TRUE(control.trouble().contains(QStringLiteral("Out of reach")));
  EXPECT_DOUBLE_EQ(control.number()->value(), 5000);
  type(control.number(), QStringLiteral("50"));
  EXPECT_TRUE(control.trouble().isEmpty());

  const QSignalSpy told(&control, &TargetControl::targetChanged);
  type(control.number(), QStringLiteral("0"));
  EXPECT_FALSE(control.trouble().isEmpty());
  EXPECT_EQ(control.number()->value(), 0);
  EXPECT_EQ(told.count(), 0);
}

TEST(TargetControl, AnotherKindOfTargetStartsAtTheValueOfTheResult) {
  TargetControl control;
  control.setTarget({Target::Kind::Error, 0.5});
  control.setAchieved({{Target::Kind::Ratio, 264.3},
                       {Target::Kind::Size, 9876},
                       {Target::Kind::Error, 0.49871},
                       {Target::Kind::MaxError, 2.34561}});
  choose(control, Target::Kind::Ratio);
  EXPECT_DOUBLE_EQ(control.target().value, 264.3);
  choose(control, Target::Kind::Size);
  EXPECT_DOUBLE_EQ(control.target().value, 9876);
  choose(control, Target::Kind::MaxError);
  EXPECT_DOUBLE_EQ(control.target().value, 2.35);  // rounded up, so that the result meets it
  choose(control, Target::Kind::Error);
  EXPECT_DOUBLE_EQ(control.target().value, 0.5);  // the other kinds have no achieved value yet
}

TEST(TargetControl, ADraggedNumberHasThreeDigitsAndEveryStepOfTheSliderCounts) {
  TargetControl control;
  for (const auto kind : {Target::Kind::Ratio, Target::Kind::Error, Target::Kind::Visibility}) {
    control.setTarget({kind, 3});
    for (int step = 0; step < 150; ++step) {
      const int before = control.slider()->value();
      QTest::keyClick(control.slider(), Qt::Key_Right);
      ASSERT_EQ(control.slider()->value(), before + 1);
      const double value = control.target().value;
      EXPECT_EQ(value, QString::number(value, 'g', 3).toDouble());
    }
  }
}

TEST(StudioStyle, ADragThatBeginsBesideTheHandleIsFollowed) {
  StudioStyle style;
  QSlider slider(Qt::Horizontal);
  slider.setStyle(&style);
  slider.setRange(0, 1000);
  slider.resize(500, 30);
  QTest::mousePress(&slider, Qt::LeftButton, {}, {300, 15});
  EXPECT_NEAR(slider.value(), 600, 30);
  QTest::mouseMove(&slider, {400, 15});
  EXPECT_NEAR(slider.value(), 800, 30);
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, {400, 15});
}

TEST(StudioStyle, AButtonThatIsOnStandsOutInBothThemes) {
  StudioStyle style;
  QToolButton button;
  button.setStyle(&style);
  button.setCheckable(true);
  button.resize(80, 30);
  for (const QPalette& palette : {lightPalette(), darkPalette()}) {
    button.setPalette(palette);
    const auto edge = [&](bool on) {
      button.setChecked(on);
      return button.grab().toImage().pixelColor(1, 15);
    };
    const QColor off = edge(false);
    const QColor on = edge(true);
    EXPECT_GT(std::abs(on.red() - off.red()) + std::abs(on.green() - off.green()) +
                  std::abs(on.blue() - off.blue()),
              40);
  }
}

TEST(StudioStyle, ASliderThatIsDisabledIsPaler) {
  StudioStyle style;
  QSlider slider(Qt::Horizontal);
  slider.setStyle(&style);
  slider.setPalette(lightPalette());
  slider.resize(200, 30);
  slider.setValue(50);
  // Sums the darkness of all pixels.
  const auto ink = [&slider] {
    QImage picture(slider.size(), QImage::Format_RGB32);
    picture.fill(Qt::white);
    slider.render(&picture, {}, {}, QWidget::DrawChildren);
    int sum = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) sum += 255 - qGray(picture.pixel(x, y));
    return sum;
  };
  const int enabled = ink();
  slider.setEnabled(false);
  EXPECT_LT(ink(), 0.6 * enabled);
}

TEST(NumberBox, TypedValuesHaveThreeDigits) {
  NumberBox box;
  box.setDecimalsShown(1, 6);
  const auto typed = [&](const char* text) {
    box.selectAll();
    QTest::keyClicks(&box, QString::fromLatin1(text));
    QTest::keyClick(&box, Qt::Key_Return);
    return box.value();
  };
  EXPECT_DOUBLE_EQ(typed("1.002305"), 1);
  EXPECT_DOUBLE_EQ(typed("36.885"), 36.9);
  EXPECT_DOUBLE_EQ(typed("0.0123456"), 0.0123);
  EXPECT_DOUBLE_EQ(typed("12345"), 12345) << "bytes are counted";
}

TEST(TargetControl, WithoutAResultEveryKindStartsAtAUsualValue) {
  TargetControl control;
  for (const auto kind : {Target::Kind::Size, Target::Kind::Error, Target::Kind::MaxError,
                          Target::Kind::Visibility, Target::Kind::Ratio}) {
    choose(control, kind);
    EXPECT_EQ(control.target().kind, kind);
    EXPECT_GT(control.target().value, 0);
  }
  EXPECT_DOUBLE_EQ(control.target().value, Target().value);
}

TEST(CompressionPanel, EmitsOnlyForChoicesOfTheUser) {
  CompressionPanel panel;
  std::vector<EncodeSettings> chosen;
  QObject::connect(&panel, &CompressionPanel::optionsChanged,
                   [&](const EncodeSettings& options) { chosen.push_back(options); });
  EncodeSettings options;
  options.method = Method::Standard;
  options.coding = Coding::Rle16;
  options.seed = 9;
  options.target = {Target::Kind::Ratio, 50};
  panel.setOptions(options);
  EXPECT_TRUE(chosen.empty());
  panel.target()->slider()->setValue(0);
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(chosen[0].method, Method::Standard);
  EXPECT_EQ(chosen[0].coding, Coding::Rle16);
  EXPECT_EQ(chosen[0].seed, 9U);
  EXPECT_NEAR(chosen[0].target.value, 2, 1e-9);
}

TEST(JointsPanel, LeavesRoomForNamesHoweverNarrowItIs) {
  JointErrorModel model;
  JointsPanel panel(&model);
  model.setLandmarks(landmarks(test::small_skeleton()));
  panel.resize(260, 300);
  panel.show();
  QApplication::processEvents();
  const auto* view = panel.findChild<QTreeView*>();
  EXPECT_GE(view->columnWidth(JointErrorModel::Name), view->fontMetrics().averageCharWidth() * 12);
  panel.resize(900, 300);
  QApplication::processEvents();
  EXPECT_EQ(view->header()->length(), view->viewport()->width());
}

TEST(CompressionPanel, AsksForTheErrorOfTracksWhereThereAreAny) {
  CompressionPanel panel;
  std::vector<double> chosen;
  QObject::connect(&panel, &CompressionPanel::trackErrorChanged,
                   [&](double track_error) { chosen.push_back(track_error); });
  EXPECT_TRUE(panel.trackError()->parentWidget()->isHidden());
  panel.setHasTracks(true);
  EXPECT_FALSE(panel.trackError()->parentWidget()->isHidden());
  panel.setTrackError(0.01);
  EXPECT_TRUE(chosen.empty());
  panel.trackError()->setValue(0.005);
  EXPECT_EQ(chosen, std::vector<double>{0.005});
}

TEST(CompressionPanel, EveryControlHasANameAndAnExplanation) {
  CompressionPanel panel;
  QWidgetList controls;
  for (QWidget* control : panel.findChildren<QComboBox*>()) controls << control;
  for (QWidget* control : panel.findChildren<QAbstractSpinBox*>()) controls << control;
  for (QWidget* control : panel.findChildren<QSlider*>()) controls << control;
  EXPECT_EQ(controls.size(), 14);
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
  EXPECT_TRUE(texts.contains(QStringLiteral("4.6 mm")));
  EXPECT_EQ(texts.count(QStringLiteral("–")), 9);
}

TEST(ResultPanel, HasRoomForALongerRatioAtOnce) {
  ResultPanel panel;
  panel.resize(320, 200);
  panel.show();
  panel.setFigures(ResultFigures{.ratio = 9});
  panel.setFigures(ResultFigures{.ratio = 1180, .size_is_estimated = true});
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->wordWrap()) continue;
    EXPECT_GE(label->width(), label->sizeHint().width()) << qPrintable(label->text());
  }
}

TEST(ResultPanel, ShowsVisibilityAndTheMostVisibleJoint) {
  ResultPanel panel;
  ResultFigures figures;
  figures.seen =
      SeenFigures{Sight::Borderline, Cue::Head, QStringLiteral("Neck1"), 2.5, 1.25, 19, 15};
  panel.setFigures(figures);
  QString verdict, reason;
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->accessibleName() == QStringLiteral("Visibility")) verdict = label->text();
    if (label->accessibleName() == QStringLiteral("Most visible error")) reason = label->text();
  }
  EXPECT_EQ(verdict, QStringLiteral("borderline from 15 m"));
  EXPECT_TRUE(reason.contains(QStringLiteral("Neck1 at 2.50 s: 1.25 times"))) << qPrintable(reason);
}

TEST(ResultPanel, LeadsWithTheVerdictAndFoldsTheRest) {
  QSettings().clear();
  const auto isShown = [](const ResultPanel& panel, const QString& name) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->accessibleName() == name) return label->isVisibleTo(&panel);
    return false;
  };
  ResultPanel panel;
  ResultFigures figures;
  figures.seen = SeenFigures{Sight::Visible, Cue::Head, QStringLiteral("Neck1"), 2.5, 2.5};
  panel.setFigures(figures);
  EXPECT_TRUE(isShown(panel, QStringLiteral("Visibility")));
  EXPECT_FALSE(isShown(panel, QStringLiteral("Worst point")));
  panel.findChild<QToolButton*>()->click();
  EXPECT_TRUE(isShown(panel, QStringLiteral("Worst point")));
  EXPECT_TRUE(isShown(ResultPanel(), QStringLiteral("Worst point")));  // remembered
  QSettings().clear();
}

TEST(ResultPanel, ShowsBothEndsOfAClipAndTheSeamOfALoop) {
  ResultPanel panel;
  ResultFigures figures;
  figures.ends = EndErrors{.first_cm = 0.2,
                           .last_cm = 0.3,
                           .seam_cm = 0.12,
                           .seam_cm_per_frame = 0.05,
                           .worst_neighbours_cm = 1.4,
                           .worst_neighbours_cm_per_frame = 0.2};
  const auto texts = [&panel] {
    QStringList all;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (!label->isHidden()) all << label->text();
    return all.join(QLatin1Char('|'));
  };
  const auto has = [&](const char* text) { return texts().contains(QString::fromUtf8(text)); };
  panel.setFigures(figures);
  EXPECT_TRUE(has("First / last pose|2.0 mm / 3.0 mm|")) << texts().toStdString();
  EXPECT_FALSE(has("/frame"));
  figures.is_loop = true;
  panel.setFigures(figures);
  EXPECT_TRUE(has("Loop: seam|1.2 mm, 0.5 mm/frame|Loop: elsewhere|1.40 cm, 2.0 mm/frame|"))
      << texts().toStdString();
  EXPECT_FALSE(has("First / last"));
  panel.setFigures({});
  EXPECT_FALSE(has("/frame"));
}

TEST(ResultPanel, ShowsTheDriftOfFeetBesideTheirPath) {
  ResultPanel panel;
  ResultFigures figures;
  figures.footskate_cm = 28.7;
  figures.slide = SlidePerContact{
      .mean_cm = 0.04, .worst_cm = 2.39, .drift_mean_cm = 0.03, .drift_worst_cm = 0.21};
  panel.setFigures(figures);
  QStringList texts;
  for (const QLabel* label : panel.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("0.3 mm / 2.1 mm"))) << texts.join(u'|').toStdString();
  EXPECT_TRUE(texts.contains(QStringLiteral("+28.7 cm / +2.39 cm")));
}

bool shown(const QWidget* widget) {
  return !widget->isHidden();
}

TEST(AnnealingPanel, HasNoAxesWhileThereIsNothingToDraw) {
  AnnealingPanel panel;
  panel.resize(300, 300);
  panel.show();
  const auto* plot = panel.findChild<QCustomPlot*>();
  EXPECT_FALSE(plot->isVisible());
  panel.begin({});
  panel.append({{0, 0, 8, 8, 1.0}, {0, 1, 8, 8, 0.9}});
  EXPECT_TRUE(plot->isVisible());
  panel.await();
  EXPECT_FALSE(plot->isVisible());
}

TEST(AnnealingPanel, CanBeCancelledOnlyWhileItRuns) {
  AnnealingPanel panel;
  auto* cancel = panel.findChild<QPushButton*>();
  EXPECT_FALSE(cancel->isEnabled());
  panel.begin({});
  panel.append({{0, 0, 8, 8, 1.0}, {0, 1, 8, 8, 0.9}, {1, 0, 8, 8, 1.1}});
  const QSignalSpy cancelled(&panel, &AnnealingPanel::cancelRequested);
  cancel->click();
  EXPECT_EQ(cancelled.count(), 1);
  panel.end();
  EXPECT_FALSE(cancel->isEnabled());
}

TEST(AnnealingPanel, TheBarMovesWhileItRunsAndIsGoneAfter) {
  AnnealingPanel panel;
  const auto* bar = panel.findChild<QProgressBar*>();
  EXPECT_FALSE(shown(bar));
  panel.begin({.method = Method::ClosedLoop});
  EXPECT_TRUE(shown(bar));
  EXPECT_EQ(bar->value(), 0);
  int before = 0;
  for (int pass = 1; pass < 9; ++pass) {
    panel.append({{.pass = pass, .iteration = 3, .eps_cm = 1}});
    EXPECT_GT(bar->value(), before);
    EXPECT_LT(bar->value(), bar->maximum());
    before = bar->value();
  }
  panel.end();
  EXPECT_FALSE(shown(bar));
}

TEST(AnnealingPanel, TheCurveIsOfThePresentRun) {
  AnnealingPanel panel;
  const auto* plot = panel.findChild<QCustomPlot*>();
  panel.begin({});
  panel.append({{0, 0, 8, 8, 1.0}, {0, 1, 4, 8, 0.9}});
  panel.end();
  EXPECT_EQ(plot->graphCount(), 1) << "of the run that ended";
  panel.await();
  EXPECT_EQ(plot->graphCount(), 0);
  panel.append({{0, 2, 4, 8, 0.8}});
  EXPECT_EQ(plot->graphCount(), 0) << "of a run that was superseded";
}

TEST(AnnealingPanel, ShowsThatASlowAnswerIsOnItsWay) {
  AnnealingPanel panel;
  const auto* bar = panel.findChild<QProgressBar*>();
  panel.await();
  panel.end();  // belongs to the earlier run
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown(bar); }, 60'000));
  EXPECT_EQ(bar->maximum(), 0);
  panel.rest();
  EXPECT_FALSE(shown(bar));
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

TEST(Notices, NeverMakeTheirWindowWider) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* bar = new MessageBar(&window);
  column->addWidget(bar);
  bar->showError(QStringLiteral("no"));
  window.show();
  const int before = window.minimumSizeHint().width();
  bar->showError(QString(400, QLatin1Char('w')));
  EXPECT_LE(window.minimumSizeHint().width(), before);
  EXPECT_TRUE(bar->text().size() == 400) << "and keep every word";
}

TEST(ErrorGraph, AClickSeeksToTheFrameThere) {
  ErrorGraph graph;
  graph.resize(600, 300);
  graph.show();
  graph.setErrors(std::make_shared<Distortion>(
                      Distortion{.distances = Eigen::MatrixXf::Random(101, 3).cwiseAbs()}),
                  100, {{QStringLiteral("a"), Qt::red, 0}});
  graph.setCurves({{QStringLiteral("a"), Qt::red, 0}, {QStringLiteral("b"), Qt::blue, 2}});
  runDueEvents();
  auto* plot = graph.findChild<QCustomPlot*>();
  EXPECT_EQ(plot->graphCount(), 3);  // and the maximum of all landmarks
  const QSignalSpy sought(&graph, &ErrorGraph::seekRequested);
  const int x = static_cast<int>(plot->xAxis->coordToPixel(0.4));
  QTest::mouseClick(plot, Qt::LeftButton, {}, {x, plot->height() / 2});
  ASSERT_GE(sought.count(), 1);
  EXPECT_NEAR(sought[0][0].toInt(), 40, 1);
}

TEST(ErrorGraph, DrawsAnglesOnAnAxisInDegrees) {
  ErrorGraph graph;
  Distortion errors{.distances = Eigen::MatrixXf::Constant(101, 3, 0.5F),
                    .turns = Eigen::MatrixXf::Constant(101, 3, 20)};
  graph.setErrors(
      std::make_shared<Distortion>(errors), 100,
      {{QStringLiteral("hand"), Qt::red, 1}, {QStringLiteral("hand end"), Qt::blue, 2}});
  auto* plot = graph.findChild<QCustomPlot*>();
  EXPECT_LT(plot->yAxis->range().upper, 1);
  graph.setQuantity(ErrorQuantity::Angle);
  EXPECT_GT(plot->yAxis->range().upper, 20);
  EXPECT_TRUE(plot->yAxis->label().contains(QStringLiteral("°")));
  EXPECT_EQ(plot->graph(1)->data()->at(50)->value, 20);
}

void showFourLongNames(ErrorGraph& graph) {
  std::vector<ErrorCurve> curves;
  for (int i = 0; i < 4; ++i)
    curves.push_back({QStringLiteral("a joint of a long name %1").arg(i), Qt::red, i});
  graph.setErrors(
      std::make_shared<Distortion>(Distortion{.distances = Eigen::MatrixXf::Ones(10, 4)}), 120,
      curves);
  graph.show();
}

TEST(ErrorGraph, ItsLegendIsWholeBesideTheSwitchHoweverNarrow) {
  ErrorGraph graph;
  QAction degrees(QStringLiteral("Degrees"));
  graph.setSwitch(&degrees);
  showFourLongNames(graph);
  auto* plot = graph.findChild<QCustomPlot*>();
  const auto* button = graph.findChild<QToolButton*>();
  int rows_before = 0;
  for (const int width : {1600, 600, 300}) {
    graph.resize(width, 300);
    runDueEvents();
    for (int i = 0; i < plot->legend->itemCount(); ++i) {
      const QCPAbstractLegendItem* item = plot->legend->item(i);
      if (!item) continue;
      EXPECT_GE(item->outerRect().width(), item->minimumOuterSizeHint().width()) << width;
      EXPECT_LT(item->outerRect().right(), button->geometry().left()) << width;
    }
    EXPECT_GT(plot->legend->rowCount(), rows_before);
    rows_before = plot->legend->rowCount();
  }
}

TEST(ErrorGraph, ItsLegendIsOneWholeLineInALowPanel) {
  ErrorGraph graph;
  QAction degrees(QStringLiteral("Degrees"));
  graph.setSwitch(&degrees);
  showFourLongNames(graph);
  auto* plot = graph.findChild<QCustomPlot*>();
  for (const QSize size : {QSize(1600, 110), QSize(600, 110), QSize(300, 110), QSize(600, 80)}) {
    graph.resize(size);
    runDueEvents();
    EXPECT_EQ(plot->legend->rowCount(), 1) << size.width();
    ASSERT_GT(plot->legend->itemCount(), 0) << size.width();
    for (int i = 0; i < plot->legend->itemCount(); ++i) {
      const QCPAbstractLegendItem* item = plot->legend->item(i);
      // The layout rounds by a pixel.
      EXPECT_GE(item->outerRect().height() + 1, item->minimumOuterSizeHint().height())
          << size.width();
    }
    EXPECT_GT(plot->axisRect()->height(), size.height() - 75) << size.width();
  }
  EXPECT_LT(plot->legend->itemCount(), 5);
  graph.resize(300, 300);
  runDueEvents();
  EXPECT_GT(plot->legend->rowCount(), 1);
}

TEST(ErrorGraph, TellsBothErrorsWhereItIsPointedAt) {
  ErrorGraph graph;
  graph.resize(600, 300);
  graph.show();
  Distortion errors{.distances = Eigen::MatrixXf::Constant(101, 3, 0.5F),
                    .turns = Eigen::MatrixXf::Constant(101, 3, 20)};
  errors.turns(40, 1) = 7;
  graph.setErrors(std::make_shared<Distortion>(errors), 100,
                  {{QStringLiteral("hand"), Qt::red, 1}});
  runDueEvents();
  auto* plot = graph.findChild<QCustomPlot*>();
  const QPoint at(static_cast<int>(std::lround(plot->xAxis->coordToPixel(0.4))),
                  plot->height() / 2);
  QHelpEvent help(QEvent::ToolTip, at, plot->mapToGlobal(at));
  QApplication::sendEvent(plot, &help);
  EXPECT_EQ(QToolTip::text().toStdString(),
            "Frame 41\nhand: 5.0 mm · 7.0°\nworst of all joints: 5.0 mm · 20.0°");
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

TEST(TransportBar, OffersTheTakesOfAFileWhereThereAreSeveral) {
  Playback playback;
  QObject owner;
  TransportBar bar(&playback, TransportBar::makeActions(&playback, &owner));
  playback.setClip(50, 100);
  const auto choosers = bar.findChildren<QComboBox*>();
  const auto found = std::find_if(choosers.begin(), choosers.end(), [](const QComboBox* each) {
    return each->accessibleName() == QStringLiteral("Take");
  });
  ASSERT_NE(found, choosers.end());
  QComboBox* takes = *found;
  QSignalSpy chosen(&bar, &TransportBar::takeChosen);
  bar.setTakes({QStringLiteral("walk")}, 0);
  EXPECT_TRUE(takes->isHidden());
  bar.setTakes({QStringLiteral("walk"), QStringLiteral("run")}, 1);
  EXPECT_FALSE(takes->isHidden());
  EXPECT_EQ(takes->currentIndex(), 1);
  EXPECT_TRUE(chosen.isEmpty());
  QTest::keyClick(takes, Qt::Key_Up);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.front().front().toInt(), 0);
}

}  // namespace
}  // namespace mocapress
