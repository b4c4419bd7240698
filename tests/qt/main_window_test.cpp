// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's window without a screen.
#include "app/studio/window/main_window.h"

#include <gtest/gtest.h>

#include <qcustomplot.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QTreeView>
#include <algorithm>
#include <memory>

#include "app/studio/batch/batch_session.h"
#include "app/studio/window/tabs_below.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/correction_control.h"
#include "widgets/panels/joints_panel.h"
#include "widgets/panels/library_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/number_fields.h"
#include "widgets/panels/target_control.h"
#include "widgets/plots/error_graph.h"
#include "widgets/plots/heat_map.h"
#include "widgets/timeline/error_strip.h"
#include "widgets/timeline/sight_strip.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

class StudioWindowTest : public testing::Test {
 protected:
  StudioWindowTest() {
    QSettings().clear();
    window_.resize(1440, 900);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  ~StudioWindowTest() override { QSettings().clear(); }

  QString clip(const QString& name, int frames = 60) const {
    const QString path = directory_.filePath(name);
    QDir().mkpath(QFileInfo(path).path());
    write_motion(path.toStdU16String(), test::smooth_motion(frames));
    return path;
  }

  template <typename Act>
  void settleAfter(Act act) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.session().busy(); }, kPatience));
  }

  /// A panel behind another tab is outside the window.
  bool isInSight(const QWidget* panel) const {
    return panel->isVisible() &&
           window_.rect().contains(panel->mapTo(&window_, panel->rect().center()));
  }

  bool unfolded() const { return window_.views().joints->height() > 50; }

  /// Brings a panel to the front of its tabs.
  void bringUp(QWidget* panel) {
    auto* dock = qobject_cast<QDockWidget*>(panel->parent());
    ASSERT_TRUE(dock);
    dock->show();
    const auto is_in_sight = [&] {
      dock->raise();
      return isInSight(panel);
    };
    ASSERT_TRUE(QTest::qWaitFor(is_in_sight, kPatience));
  }

  static ErrorScale distanceScale(MainWindow& window) {
    return window.errorDisplay()
        ->scales(ErrorQuantity::Distance)
        ->scaleFor(window.session().document().decoded());
  }

  QAction* scale(double cm) {
    for (QAction* action : window_.actions().error_scales->actions())
      if (action->data().toDouble() == cm) return action;
    return nullptr;
  }

  QTemporaryDir directory_;
  MainWindow window_;
  Document& document_ = window_.session().document();
};

using StudioWithoutAScreen = StudioWindowTest;

TEST(StudioWindow, IsNoHigherThanTheScreenAtTheFirstStart) {
  QSettings().clear();
  const MainWindow window;
  EXPECT_LT(window.height(), window.screen()->availableSize().height());
}

TEST_F(StudioWithoutAScreen, KeysGoToTheViewAtTheStart) {
  EXPECT_EQ(window_.focusWidget(), window_.views().viewport);
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_End);
  EXPECT_EQ(window_.playback().frame(), 59);
}

TEST_F(StudioWithoutAScreen, AltHOpensHelp) {
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_H, Qt::AltModifier);
  const auto help = [&] {
    const auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    return menu && menu->actions().contains(window_.actions().guide);
  };
  EXPECT_TRUE(QTest::qWaitFor(help, kPatience));
  if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
  EXPECT_FALSE(window_.views().compression->correction()->hold()->isChecked());
}

TEST_F(StudioWithoutAScreen, ShortcutsWinInANumberFieldAndTypedTextInATextField) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  auto* number = window_.views().compression->target()->findChild<NumberBox*>();
  const double before = document_.options().target.value;
  number->setFocus();
  number->selectAll();
  settleAfter([&] {
    QTest::keyClicks(number, QStringLiteral("31"));
    QTest::keyClick(number, Qt::Key_Return);
  });
  EXPECT_EQ(document_.options().target.value, 3.1) << "31 mm";
  settleAfter([&] { QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier); });
  EXPECT_EQ(document_.options().target.value, before);
  QSignalSpy batch(window_.actions().batch, &QAction::triggered);
  QTest::keyClick(number, Qt::Key_E, Qt::ControlModifier);
  EXPECT_EQ(batch.count(), 1);

  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  auto* text = window_.libraryPanel().findChild<QLineEdit*>();
  ASSERT_TRUE(text);
  text->setFocus();
  QTest::keyClicks(text, QStringLiteral("run n"));
  EXPECT_EQ(text->text(), QStringLiteral("run n"));
  QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(text->text(), QStringLiteral("run n"));
  EXPECT_EQ(document_.options().target.value, before);
  QTest::keyClick(text, Qt::Key_E, Qt::ControlModifier);
  EXPECT_EQ(batch.count(), 2);
}

TEST_F(StudioWithoutAScreen, UndoActsOnWhatIsWorkedIn) {
  settleAfter([&] { window_.files().open(clip("walk.bvh", 70)); });
  settleAfter([&] { window_.files().open(clip("run.bvh")); });
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const double before = document_.options().target.value;
  EncodeSettings options = document_.options();
  options.target.value = before / 2;
  settleAfter([&] { window_.session().setOptions(options); });
  const auto clips = [this] { return window_.library().project().clips.size(); };
  QAction* undo = window_.actions().undo;

  // Undo goes to the last step.
  window_.library().remove({0});
  EXPECT_TRUE(undo->text().contains(QStringLiteral("Remove Clip"))) << qPrintable(undo->text());
  undo->trigger();
  EXPECT_EQ(clips(), 2u);
  EXPECT_DOUBLE_EQ(document_.options().target.value, before / 2);

  // Undo goes to the last focus.
  window_.libraryPanel().view()->setFocus();
  window_.views().viewport->setFocus();
  settleAfter([&] { undo->trigger(); });
  EXPECT_DOUBLE_EQ(document_.options().target.value, before);
  EXPECT_EQ(clips(), 2u);
  window_.libraryPanel().view()->setFocus();
  window_.actions().redo->trigger();
  EXPECT_EQ(clips(), 1u);
  EXPECT_DOUBLE_EQ(document_.options().target.value, before);

  // A user who opens another clip from the library stays in the library.
  settleAfter([&] { window_.library().openClip(0); });
  undo->trigger();
  EXPECT_EQ(clips(), 2u);
  // A shortcut changes the clip.
  options = document_.options();
  options.target.value = before / 4;
  settleAfter([&] { window_.session().setOptions(options); });
  settleAfter([&] { undo->trigger(); });
  EXPECT_NE(document_.options().target.value, before / 4);
  EXPECT_EQ(clips(), 2u);
}

TEST_F(StudioWindowTest, NoticesThatAFileChangesThoughNobodyComesBackToTheWindow) {
  settleAfter([&] { window_.files().open(clip(QStringLiteral("walk.bvh"))); });
  const auto hash = [&] { return window_.library().project().clips.front().stamp.hash; };
  const std::string before = hash();
  clip(QStringLiteral("walk.bvh"), 90);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hash() != before; }, kPatience));
}

TEST_F(StudioWithoutAScreen, UndoOfAClipThatOneComesBackToStopsBeforeTheLibrary) {
  settleAfter([&] { window_.open({clip("one.bvh", 70), clip("two.bvh")}); });
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  const double before = document_.options().target.value;
  EncodeSettings options = document_.options();
  options.target.value = before / 2;
  settleAfter([&] { window_.session().setOptions(options); });
  window_.libraryPanel().view()->setFocus();
  settleAfter([&] { window_.library().openClip(1); });
  settleAfter([&] { window_.library().openClip(0); });
  QAction* undo = window_.actions().undo;
  settleAfter([&] { undo->trigger(); });
  EXPECT_DOUBLE_EQ(document_.options().target.value, before);
  EXPECT_FALSE(undo->isEnabled());
  undo->trigger();
  EXPECT_EQ(window_.library().project().clips.size(), 2u);
}

TEST_F(StudioWithoutAScreen, TheQueueOfTheBatchIsThatOfTheProject) {
  window_.library().begin(directory_.filePath(QStringLiteral("data")));
  settleAfter([&] { window_.open({clip("one.bvh", 70), clip("two.bvh")}); });
  ASSERT_TRUE(window_.library().saveAs(directory_.filePath(QStringLiteral("a.mocapress"))));
  window_.actions().export_library->trigger();
  auto* batch = window_.findChild<BatchSession*>();
  ASSERT_TRUE(batch);
  ASSERT_TRUE(QTest::qWaitFor([&] { return batch->queue()->rowCount() == 2; }, kPatience));
  ASSERT_TRUE(window_.library().startNew());
  EXPECT_EQ(batch->queue()->rowCount(), 0);
  ASSERT_TRUE(window_.library().open(directory_.filePath(QStringLiteral("a.mocapress"))));
  EXPECT_EQ(batch->queue()->rowCount(), 2);
}

TEST_F(StudioWithoutAScreen, ABatchsResultsAreInTheLibrary) {
  window_.library().begin(directory_.filePath(QStringLiteral("data")));
  window_.library().add({clip("one.bvh", 70), clip("two.bvh")});
  window_.library().setVerdict({0}, Verdict::Approved);
  window_.actions().export_library->trigger();
  auto* batch = window_.findChild<BatchSession*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return batch->queue()->rowCount() == 2; }, kPatience));
  BatchSettings settings = batch->settings();
  settings.folder = directory_.filePath(QStringLiteral("out"));
  batch->setSettings(settings);
  batch->start();
  ASSERT_TRUE(batch->running());
  EXPECT_FALSE(window_.library().startNew()) << "not while its batch runs";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !batch->running(); }, kPatience));
  for (const ProjectClip& made : window_.library().project().clips) {
    ASSERT_TRUE(made.outcome);
    EXPECT_GT(made.outcome->ratio, 1);
    EXPECT_TRUE(made.outcome->sight);
    EXPECT_EQ(outdated(made), Staleness::None);
  }
  // The clip was approved before it was compressed.
  EXPECT_EQ(staleVerdict(window_.library().project().clips[0]), Staleness::Settings);
}

TEST_F(StudioWithoutAScreen, AVerdictReachesAllThatIsSelectedInTheLibrary) {
  settleAfter([&] { window_.open({clip("one.bvh", 70), clip("two.bvh"), clip("three.bvh", 60)}); });
  LibraryPanel& panel = window_.libraryPanel();
  panel.view()->selectAll();
  QComboBox* verdict = panel.verdict();
  verdict->setCurrentIndex(verdict->findData(static_cast<int>(Verdict::Rejected)));
  emit verdict->activated(verdict->currentIndex());
  for (const ProjectClip& one : window_.library().project().clips)
    EXPECT_EQ(one.review.verdict, Verdict::Rejected);
  EXPECT_EQ(panel.chosenRows().size(), 3u) << "still selected";
  window_.actions().undo->trigger();
  for (const ProjectClip& one : window_.library().project().clips)
    EXPECT_EQ(one.review.verdict, Verdict::None);
}

TEST_F(StudioWithoutAScreen, SeveralFilesComeIntoTheLibraryAndTheFirstIsOpened) {
  const QStringList clips = {clip("one.bvh", 70), clip("two.bvh"), clip("three.bvh")};
  settleAfter([&] { window_.open(clips); });
  ASSERT_EQ(window_.library().project().clips.size(), 3u);
  EXPECT_TRUE(window_.session().isOpen(clips[0]));
  EXPECT_EQ(document_.frames(), 70);
}

TEST_F(StudioWithoutAScreen, AFolderComesIntoTheLibraryAndItsFirstClipIsOpened) {
  clip("walks/a/one.bvh");
  clip("walks/b/two.bvh");
  settleAfter([&] { window_.open({directory_.filePath(QStringLiteral("walks"))}); });
  EXPECT_EQ(window_.library().project().clips.size(), 2u);
  EXPECT_TRUE(document_.original());
}

TEST_F(StudioWithoutAScreen, TellsWhichFilesTheLibraryRefuses) {
  QFile notes(directory_.filePath(QStringLiteral("notes.txt")));
  ASSERT_TRUE(notes.open(QIODevice::WriteOnly));
  window_.open({clip("one.bvh"), clip("two.bvh"), notes.fileName()});
  EXPECT_TRUE(window_.messages().text().contains(QStringLiteral("notes.txt")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return document_.final() && document_.decoded(); }, kPatience));
}

TEST_F(StudioWithoutAScreen, AProjectIsOpenedAsWhatItIs) {
  const QString project = directory_.filePath(QStringLiteral("knights.mocapress"));
  const QString walk = clip("walk.bvh", 70);
  writeProject(project, {.current = walk, .clips = {{.path = clip("run.bvh")}, {.path = walk}}});
  settleAfter([&] { window_.open({project}); });
  EXPECT_EQ(window_.library().name(), QStringLiteral("knights"));
  EXPECT_EQ(window_.library().project().clips.size(), 2u);
  EXPECT_TRUE(window_.session().isOpen(walk));
  EXPECT_FALSE(window_.messages().isVisible());
}

TEST_F(StudioWithoutAScreen, ClipsBesideAProjectComeIntoItAndOneProjectIsOpened) {
  const QString project = directory_.filePath(QStringLiteral("knights.mocapress"));
  const QString other = directory_.filePath(QStringLiteral("pages.mocapress"));
  const QString walk = clip("walk.bvh");
  writeProject(project, {.current = walk, .clips = {{.path = walk}}});
  writeProject(other, {});
  settleAfter([&] { window_.open({clip("run.bvh"), project, clip("jump.bvh"), other}); });
  EXPECT_EQ(window_.library().name(), QStringLiteral("knights"));
  EXPECT_EQ(window_.library().project().clips.size(), 3u);
  EXPECT_TRUE(window_.session().isOpen(walk)) << "where the project was left";
  EXPECT_TRUE(window_.messages().text().contains(QStringLiteral("pages.mocapress")));
  EXPECT_FALSE(window_.messages().text().contains(QStringLiteral("knights.mocapress")));
}

TEST_F(StudioWithoutAScreen, ClipsWithoutANameAreAskedAboutBeforeAProjectThatIsDropped) {
  const QString project = directory_.filePath(QStringLiteral("knights.mocapress"));
  writeProject(project, {.clips = {{.path = clip("run.bvh")}}});
  settleAfter([&] { window_.open({clip("walk.bvh")}); });
  window_.open({project});
  auto* question = window_.findChild<QMessageBox*>();
  ASSERT_TRUE(question);
  question->button(QMessageBox::Cancel)->click();
  EXPECT_TRUE(window_.library().name().isEmpty());
  EXPECT_TRUE(document_.original());
}

TEST_F(StudioWithoutAScreen, OneErrorScaleHoldsForAllAndIsRemembered) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  ASSERT_TRUE(scale(0)->isChecked()) << "it fits what is shown until another is chosen";
  const ErrorScale automatic = errorScaleFor(document_.decoded()->distortion->p99);
  EXPECT_EQ(distanceScale(window_), automatic);
  const auto pictures = [&] {
    return std::pair(window_.inspection().timeline->errors()->grab().toImage(),
                     distanceScale(window_).top);
  };
  scale(5)->trigger();
  const auto [before, top] = pictures();
  EXPECT_DOUBLE_EQ(top, 5);
  scale(0.1)->trigger();
  const auto [after, finer] = pictures();
  EXPECT_DOUBLE_EQ(finer, 0.1);
  EXPECT_NE(after, before);
  scale(0)->trigger();
  EXPECT_EQ(distanceScale(window_), automatic);
  scale(0.5)->trigger();
  MainWindow next;
  EXPECT_DOUBLE_EQ(distanceScale(next).top, 0.5);
}

TEST_F(StudioWithoutAScreen, HeatMapAndGraphTellDegreesByOneSwitchThatIsRemembered) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  HeatMap* map = window_.inspection().heat_map;
  const auto* graph = window_.views().graph->findChild<QCustomPlot*>();
  bringUp(map);
  const auto picture = [map] { return map->grab().toImage(); };
  const QImage in_cm = picture();
  const QImage strip = window_.inspection().timeline->errors()->grab().toImage();
  const QString axis = graph->yAxis->label();
  QAction* in_degrees = window_.actions().in_degrees;
  in_degrees->trigger();
  window_.actions().angle_scales->actions().at(2)->trigger();
  const QImage by_five_degrees = picture();
  EXPECT_NE(by_five_degrees, in_cm);
  EXPECT_NE(graph->yAxis->label(), axis);
  EXPECT_EQ(window_.inspection().timeline->errors()->grab().toImage(), strip);
  QAction* finest = window_.actions().angle_scales->actions().front();
  EXPECT_EQ(finest->text(), QStringLiteral("1°"));
  EXPECT_TRUE(map->actions().contains(finest));
  EXPECT_FALSE(map->actions().contains(scale(0.5)));
  finest->trigger();
  EXPECT_NE(picture(), by_five_degrees);
  const ErrorScaleChoice* angles = window_.errorDisplay()->scales(ErrorQuantity::Angle);
  window_.actions().angle_scales->actions().back()->trigger();  // automatic scale
  EXPECT_EQ(angles->scaleFor(document_.decoded()),
            errorScaleFor(document_.decoded()->distortion->p99_degrees, ErrorQuantity::Angle));
  MainWindow next;
  EXPECT_EQ(next.errorDisplay()->quantity(), ErrorQuantity::Angle);
  in_degrees->trigger();
  EXPECT_EQ(picture(), in_cm);
  EXPECT_EQ(graph->yAxis->label(), axis);
}

TEST_F(StudioWithoutAScreen, TheHeatMapTellsWhatIsSeenByASwitchThatIsRemembered) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  HeatMap* map = window_.inspection().heat_map;
  bringUp(map);
  const auto picture = [map] { return map->grab().toImage(); };
  const QImage in_cm = picture();
  window_.actions().as_seen->trigger();
  EXPECT_NE(picture(), in_cm);
  EXPECT_FALSE(map->actions().contains(scale(5))) << "thresholds are what they are";
  MainWindow next;
  EXPECT_TRUE(next.errorDisplay()->tellsSight());
  window_.actions().in_degrees->trigger();
  EXPECT_FALSE(window_.errorDisplay()->tellsSight()) << "one at a time";
  window_.actions().in_degrees->trigger();
  EXPECT_EQ(picture(), in_cm);
}

TEST_F(StudioWithoutAScreen, AShortcutRaisesThePanelThatItSwitches) {
  window_.show();
  auto* map = window_.inspection().heat_map;
  auto* graph = window_.views().graph;
  const auto dock_of = [](QWidget* panel) { return qobject_cast<QDockWidget*>(panel->parent()); };
  ASSERT_TRUE(dock_of(map) && dock_of(graph));
  bringUp(graph);
  ASSERT_FALSE(isInSight(map)) << "a tab behind the graph's";
  window_.actions().in_degrees->trigger();
  QApplication::processEvents();
  EXPECT_FALSE(isInSight(map)) << "the graph, too, shows it";
  window_.actions().as_seen->trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return isInSight(map); }, kPatience));
  for (QWidget* panel : {static_cast<QWidget*>(map), static_cast<QWidget*>(graph)})
    dock_of(panel)->hide();
  window_.actions().in_degrees->trigger();
  EXPECT_TRUE(dock_of(map)->isVisible());
  dock_of(map)->hide();
  window_.actions().as_seen->trigger();
  EXPECT_TRUE(dock_of(map)->isVisible());
}

TEST_F(StudioWithoutAScreen, TheTitleNamesTheOpenedFile) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  EXPECT_TRUE(window_.windowTitle().startsWith(QStringLiteral("walk.bvh")));
}

TEST_F(StudioWithoutAScreen, TheLibraryGetsItsWidthBackAfterASmallWindow) {
  window_.resize(1600, 900);
  window_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  runDueEvents();
  auto* dock = qobject_cast<QDockWidget*>(window_.libraryPanel().parent());
  ASSERT_TRUE(dock);
  window_.resizeDocks({dock}, {400}, Qt::Horizontal);
  runDueEvents();
  const int width = dock->width();
  ASSERT_GT(width, 350);
  // The panels below may need less width once they have the room of a low window.
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        window_.resize(window_.minimumSizeHint());
        return dock->width() < width;
      },
      kPatience));
  window_.resize(1600, 900);
  runDueEvents();
  EXPECT_EQ(dock->width(), width);
}

TEST_F(StudioWithoutAScreen, TheViewKeepsNearlyHalfOfALowWindow) {
  const QWidget* view = window_.views().viewport;
  for (const QSize size : {QSize(1280, 720), QSize(1600, 1000), QSize(1280, 720)}) {
    window_.resize(size);
    const auto is_laid_out = [&] {
      return view->height() >= 0.45 * size.height() && (unfolded() || size.height() < 1000) &&
             tabsFit(window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly));
    };
    EXPECT_TRUE(QTest::qWaitFor(is_laid_out, kPatience))
        << view->height() << " of " << size.height() << (unfolded() ? ", unfolded" : ", folded");
  }
}

TEST_F(StudioWithoutAScreen, AClickOnATabUnfoldsThePanelsBelowAndAnotherFoldsThem) {
  window_.resize(1280, 600);
  const QWidget* map = window_.inspection().heat_map;
  const auto click = [&](Qt::MouseButton button) {
    for (auto* bar : window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
      for (int tab = 0; tab < bar->count(); ++tab)
        if (bar->tabText(tab) == QStringLiteral("Heat map"))
          QTest::mouseClick(bar, button, {}, bar->tabRect(tab).center());
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !unfolded(); }, kPatience));
  click(Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return unfolded() && isInSight(map); }, kPatience));
  click(Qt::RightButton);  // else it would fold them, and the next unfold them
  click(Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !unfolded(); }, kPatience));
}

TEST_F(StudioWithoutAScreen, CommandsThatWorkOnAClipAreGreyWithoutOne) {
  const Actions& actions = window_.actions();
  const QList<QAction*> of_clip{actions.save_picture, actions.note_here,  actions.next_worst,
                                actions.hold_feet,    actions.copy_link,  actions.transport.play,
                                actions.approve,      actions.write_notes};
  for (const QAction* action : of_clip)
    EXPECT_FALSE(action->isEnabled()) << qPrintable(action->text());
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  for (const QAction* action : of_clip)
    EXPECT_TRUE(action->isEnabled()) << qPrintable(action->text());
}

TEST_F(StudioWithoutAScreen, AWindowInAnotherLanguageShowsTheSameWorkWithItsHistories) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::Ratio, 30};
  settleAfter([&] { window_.session().setOptions(options); });
  window_.work().pinned.pinCurrent();
  window_.library().setVerdict({0}, Verdict::Approved);
  window_.playback().setRange(std::pair(10, 20));
  window_.playback().seek(15);
  window_.actions().view.mode[1]->trigger();
  window_.actions().view.in_place->trigger();
  window_.actions().view.follow->trigger();
  window_.actions().view.side->trigger();
  document_.setCurrentJoint(3);
  const float azimuth = window_.views().viewport->cameraPlace().azimuth;
  MainWindow next(&window_.work());
  next.takeOver(window_.state());
  next.show();
  EXPECT_EQ(next.playback().frame(), 15);
  EXPECT_EQ(next.playback().range(), (std::pair(10, 20)));
  EXPECT_EQ(next.libraryPanel().view()->currentIndex(),
            next.libraryPanel().tree()->indexOf(next.library().currentRow()));
  EXPECT_EQ(next.views().compression->target()->number()->value(), 30);
  EXPECT_EQ(next.views().viewport->pinned().size(), 1u);
  EXPECT_EQ(next.views().viewport->options(), window_.views().viewport->options());
  EXPECT_TRUE(next.actions().view.mode[1]->isChecked());
  EXPECT_TRUE(next.actions().view.in_place->isChecked());
  EXPECT_FALSE(next.actions().view.follow->isChecked());
  EXPECT_FLOAT_EQ(next.views().viewport->cameraPlace().azimuth, azimuth);
  // The library's step, then the clip's: the pin and the target.
  next.library().history()->undo();
  EXPECT_EQ(next.library().project().clips[0].review.verdict, Verdict::None);
  next.session().history()->undo();
  EXPECT_TRUE(next.views().viewport->pinned().empty());
  next.session().history()->undo();
  EXPECT_NE(document_.options().target.value, 30);
}

TEST_F(StudioWithoutAScreen, AWindowInAnotherLanguageNamesEarlierStepsInIt) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::Ratio, 30};
  settleAfter([&] { window_.session().setOptions(options); });
  window_.library().setVerdict({0}, Verdict::Approved);
  ASSERT_EQ(window_.actions().undo->text(), QStringLiteral("&Undo Verdict"));
  QTranslator spanish;
  ASSERT_TRUE(spanish.load(QStringLiteral(":/i18n/mocapress_es.qm")));
  QCoreApplication::installTranslator(&spanish);
  {
    MainWindow next(&window_.work());
    next.takeOver(window_.state());
    const QString target = next.session().history()->undoText();
    EXPECT_NE(target, QStringLiteral("Target"));
    EXPECT_EQ(target, spanish.translate("mocapress::SettingsField", "Target"));
    next.library().history()->setActive();
    EXPECT_EQ(next.actions().undo->text(),
              QStringLiteral("%1 %2").arg(spanish.translate("mocapress::Actions", "&Undo"),
                                          spanish.translate("mocapress::Library", "Verdict")));
  }
  QCoreApplication::removeTranslator(&spanish);
}

TEST_F(StudioWithoutAScreen, TheWorkGoesOnOnceTheWindowBeforeIsGone) {
  Work work;
  auto before = std::make_unique<MainWindow>(&work);
  QSignalSpy settled(&work.session, &Session::settled);
  before->files().open(clip("walk.bvh"));
  ASSERT_TRUE(settled.wait(kPatience));
  emit before->libraryPanel().copySettingsRequested(0);
  const WindowState state = before->state();
  before.reset();
  MainWindow next(&work);
  next.takeOver(state);
  const std::unique_ptr<QMenu> menu(next.libraryPanel().makeMenu());
  const QList<QAction*> actions = menu->actions();
  EXPECT_TRUE(std::any_of(actions.begin(), actions.end(), [](const QAction* action) {
    return action->text() == QLatin1String("Paste Settings") && action->isEnabled();
  }));
  work.pinned.pinCurrent();
  EXPECT_EQ(next.views().viewport->pinned().size(), 1u);
  work.library.setVerdict({0}, Verdict::Approved);
  EXPECT_EQ(work.clips.entry(0).review.verdict, Verdict::Approved);
  EncodeSettings options = work.session.document().options();
  options.target = {Target::Kind::Ratio, 30};
  settled.clear();
  work.session.setOptions(options);
  ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  EXPECT_EQ(next.views().compression->target()->number()->value(), 30);
}

TEST_F(StudioWithoutAScreen, AClickOnWhatIsSeenGoesThereAndSelectsTheJoint) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  SightStrip* strip = window_.inspection().timeline->sight();
  QTest::mouseClick(strip, Qt::LeftButton, {}, {strip->width() - 12, strip->height() / 2});
  EXPECT_GT(window_.playback().frame(), 50);
  EXPECT_EQ(document_.currentJoint(),
            document_.decoded()->visibility->table.at(window_.playback().frame()).joint);
}

TEST_F(StudioWithoutAScreen, ATargetOutOfReachIsSaidBesideItAndStays) {
  settleAfter([&] { window_.files().open(clip("walk.bvh")); });
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::Ratio, 20};
  settleAfter([&] { window_.session().setOptions(options); });
  TargetControl* target = window_.views().compression->target();
  QSignalSpy failed(&window_.session(), &Session::compressFailed);
  target->number()->setValue(1e6);
  ASSERT_TRUE(failed.count() > 0 || failed.wait(kPatience));
  EXPECT_FALSE(target->trouble().isEmpty());
  EXPECT_DOUBLE_EQ(target->number()->value(), 1e6);
  EXPECT_DOUBLE_EQ(document_.options().target.value, 1e6);
  EXPECT_TRUE(window_.messages().isHidden()) << "said once, where it belongs";
  settleAfter([&] { target->number()->setValue(10); });
  EXPECT_TRUE(target->trouble().isEmpty());
}

TEST_F(StudioWithoutAScreen, TheRatioOfAResultIsTakenOverWhenARatioIsAskedFor) {
  settleAfter([&] { window_.files().open(clip("walk.bvh", 300)); });
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::Error, 0.4};
  settleAfter([&] { window_.session().setOptions(options); });
  const double ratio = document_.decoded()->ratio;
  TargetControl* target = window_.views().compression->target();
  const int index = target->kind()->findData(static_cast<int>(Target::Kind::Ratio));
  target->kind()->setCurrentIndex(index);
  settleAfter([&] { emit target->kind()->activated(index); });
  EXPECT_EQ(document_.options().target.kind, Target::Kind::Ratio);
  EXPECT_NEAR(document_.options().target.value, ratio, 0.051);
  EXPECT_NEAR(document_.decoded()->ratio, ratio, 0.03 * ratio);
}

TEST_F(StudioWithoutAScreen, TheRatioThatAutoFoundIsInTheField) {
  settleAfter([&] { window_.files().open(clip("walk.bvh", 200)); });
  EncodeSettings options = document_.options();
  options.target = {Target::Kind::Ratio, 12};
  options.correction = EncodeCorrection{.joints = {4}};
  settleAfter([&] { window_.session().setOptions(options); });
  ASSERT_TRUE(document_.decoded()->correction);
  const NumberBox* number = window_.views().compression->correction()->number();
  EXPECT_NEAR(number->value(), document_.decoded()->correction->ratio, 0.001);
  EXPECT_FALSE(number->isEnabled());
}

TEST(StudioProgram, SaysHelpAndVersionWithoutADisplay) {
  for (const QString& option : {QStringLiteral("--help"), QStringLiteral("--version")}) {
    QProcess studio;
    QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
      bare.remove(QString::fromLatin1(name));
    bare.insert(QStringLiteral("LC_ALL"), QStringLiteral("C"));
    studio.setProcessEnvironment(bare);
    studio.start(QStringLiteral(MOCAPRESS_STUDIO), {option});
    ASSERT_TRUE(studio.waitForFinished(kPatience));
    EXPECT_EQ(studio.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(studio.exitCode(), 0) << studio.readAllStandardError().toStdString();
    const QByteArray words = studio.readAllStandardOutput();
    EXPECT_TRUE(words.contains(option == QLatin1String("--help") ? "--ratio" : "Mocapress"))
        << words.toStdString();
  }
}

}  // namespace
}  // namespace mocapress
