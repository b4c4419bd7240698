// SPDX-License-Identifier: GPL-3.0-or-later
// Every view of the real window, with a picture of each in the build folder.
#include <gtest/gtest.h>

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QImage>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTextBrowser>
#include <QTranslator>
#include <cstdio>
#include <string>

#include "app/studio/document/clip_files.h"
#include "app/studio/window/help.h"
#include "app/studio/window/screenshot.h"
#include "tests/qt/patience.h"
#include "tests/qt/studio_at_work.h"
#include "widgets/models/colours.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/target_control.h"
#include "widgets/plots/heat_map.h"
#include "widgets/timeline/sight_strip.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

using namespace test;

TEST_F(StudioTour, SeesTheSampleInEveryWay) {
  Studio studio;
  studio.open(sampleClip());
  studio->playback().seek(studio->session().document().decoded()->distortion->max.frame);
  const ViewActions& view = studio->actions().view;
  QImage before = studio.picture(QStringLiteral("view-overlay"));
  const auto looksDifferent = [&](QAction* action, const char* name) {
    action->trigger();
    const QImage now = studio.picture(QString::fromLatin1(name));
    EXPECT_GT(differing(before, now), 500) << name;
    before = now;
  };
  looksDifferent(view.by_error, "view-by-error");
  looksDifferent(view.mode[1], "view-side-by-side");
  looksDifferent(view.path, "view-path");
  view.path->trigger();
  looksDifferent(view.trail, "view-trail");
  looksDifferent(view.trail_poses->actions().at(2), "view-trail-long");
  view.trail->trigger();
  looksDifferent(view.mode[2], "view-wipe");
  looksDifferent(view.swap, "view-wipe-swapped");
  looksDifferent(view.floor, "view-floor");
}

TEST_F(StudioTour, PinsFourResultsAndSeesThemInEveryWay) {
  Studio studio;
  studio.open(sampleClip());
  QDockWidget* dock = studio->findChild<QDockWidget*>(QStringLiteral("pinned"));
  ASSERT_TRUE(dock);
  dock->raise();
  TargetControl* target = studio->views().compression->target();
  for (const int position : {500, 700, 850, 950}) {
    studio.settleAfter([&] { target->slider()->setValue(position); });
    studio->actions().pin->trigger();
  }
  EXPECT_FALSE(studio->actions().pin->isEnabled());
  studio.settleAfter([&] { target->slider()->setValue(600); });
  const auto& worst = studio->session().document().decoded()->distortion->max;
  studio->playback().seek(worst.frame);
  const QImage overlay = studio.picture(QStringLiteral("pinned-overlay"));
  studio->actions().view.mode[1]->trigger();
  const QImage sides = studio.picture(QStringLiteral("pinned-side-by-side"));
  EXPECT_GT(differing(overlay, sides), 5000);
  const QRect area = studio.areaOf(studio->views().viewport);
  for (const PinnedFigure& pinned : studio->views().viewport->pinned())
    for (const QImage* picture : {&overlay, &sides})
      EXPECT_GT(pixelsNear(*picture, area, pinned.colour), 30)
          << qPrintable(pinned.title.join(QLatin1Char(' ')));
}

TEST_F(StudioTour, TheGhostTrailFollowsWhileItPlays) {
  Studio studio;
  studio.open(sampleClip());
  QSignalSpy frames(&studio->playback(), &Playback::frameChanged);
  const auto play = [&](const char* what) {
    frames.clear();
    QElapsedTimer clock;
    clock.start();
    studio->actions().transport.play->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return frames.count() > 10; }, kPatience));
    studio->actions().transport.play->trigger();
    const double played = 1e3 * double(frames.count()) / double(clock.elapsed());
    constexpr int kSteps = 100;
    clock.restart();
    for (int frame = 0; frame < kSteps; ++frame) studio->views().viewport->setFrame(frame);
    std::printf("%s: %.0f pictures a second by software, %.2f ms of the GUI thread each\n", what,
                played, double(clock.elapsed()) / kSteps);
  };
  play("without a trail");
  studio->actions().view.trail->trigger();
  studio->actions().view.trail_poses->actions().at(2)->trigger();
  play("with 8 + 8 poses");
}

TEST_F(StudioTour, TheWipeWorksWhileItPlays) {
  Studio studio;
  studio.open(sampleClip());
  studio->actions().view.mode[2]->trigger();
  studio->actions().transport.play->trigger();
  QSignalSpy frames(&studio->playback(), &Playback::frameChanged);
  QWindow* scene = nullptr;
  for (QWindow* window : QGuiApplication::allWindows())
    if (window->inherits("mocapress::Scene")) scene = window;
  ASSERT_TRUE(scene);
  const int middle = scene->width() / 2;
  QTest::mousePress(scene, Qt::LeftButton, {}, {middle, 100});
  for (int x = middle; x > middle / 2; x -= 10) {
    QTest::mouseMove(scene, {x, 100});
    EXPECT_TRUE(frames.wait(kPatience));
  }
  QTest::mouseRelease(scene, Qt::LeftButton, {}, {middle / 2, 100});
  EXPECT_TRUE(studio->playback().playing());
  EXPECT_NEAR(studio->views().viewport->options().divider, 0.25, 0.03);
}

TEST_F(StudioTour, DarkThemeIsDarkEverywhere) {
  Studio studio;
  studio.open(sampleClip());
  studio->actions().themes->actions().at(2)->trigger();
  const QImage dark = studio.picture(QStringLiteral("theme-dark"));
  studio->actions().themes->actions().at(1)->trigger();
  const QImage light = studio.picture(QStringLiteral("theme-light"));
  for (const QPoint& place :
       {QPoint(20, 60), QPoint(700, 12), QPoint(1300, 65), QPoint(900, 300)}) {
    EXPECT_LT(qGray(dark.pixel(place)), 100) << place.x();
    EXPECT_GT(qGray(light.pixel(place)), 150) << place.x();
  }
}

TEST_F(StudioTour, VisibilityShowsInBothThemes) {
  Studio studio;
  studio.open(sampleClip());
  QSlider* const target = studio->views().compression->target()->slider();
  studio.settleAfter([&] { target->setValue(600); });  // with the preset it would be met
  studio->findChild<QDockWidget*>(QStringLiteral("heat-map"))->raise();
  studio->actions().as_seen->trigger();
  for (const char* theme : {"light", "dark"}) {
    studio->actions().themes->actions().at(theme == std::string("light") ? 1 : 2)->trigger();
    const QImage picture = studio.picture(QStringLiteral("seen-") + QLatin1String(theme));
    for (const QWidget* view : {static_cast<QWidget*>(studio->inspection().heat_map),
                                static_cast<QWidget*>(studio->inspection().timeline->sight())})
      EXPECT_GT(pixelsNear(picture, studio.areaOf(view), sightColour(Sight::Visible)), 100);
  }
}

TEST_F(StudioTour, HelpShowsAnIllustratedGuideAndEveryKey) {
  Studio studio;
  const auto shown = [&](QAction* action) {
    action->trigger();
    auto* window = studio->findChildren<HelpWindow*>().last();
    return window->findChild<QTextBrowser*>();
  };
  QTextBrowser* guide = shown(studio->actions().guide);
  EXPECT_GT(guide->toPlainText().size(), 1000);
  EXPECT_GE(guide->toHtml().count(QStringLiteral("<img")), 4);
  for (const char* picture : {"compare", "inspect", "curve", "pinned"})
    EXPECT_GT(QImage(QStringLiteral(":/guide/%1_en.png").arg(QLatin1String(picture))).width(), 400);
  const QString keys = shown(studio->actions().shortcuts)->toPlainText();
  for (const QAction* action : studio->findChildren<QAction*>()) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    EXPECT_TRUE(keys.contains(key)) << qPrintable(action->text());
  }
}

}  // namespace
}  // namespace mocapress
