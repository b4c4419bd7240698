// SPDX-License-Identifier: GPL-3.0-or-later
// A working session in the real window, with a picture of each step in the build folder. Needs an X
// display with OpenGL (Xvfb will do).
#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QImage>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "app/studio/main_window.h"
#include "app/studio/sample_clip.h"
#include "app/studio/screenshot.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr int kPatience = 60'000;  // ms

QString picturePath(const QString& name) {
  const QDir folder(QStringLiteral(MOCAPRESS_BINARY_DIR "/pictures"));
  folder.mkpath(QStringLiteral("."));
  return folder.filePath(name + QStringLiteral(".png"));
}

/// A window at work.
class Studio {
 public:
  Studio() {
    window_.resize(1440, 900);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }

  MainWindow* operator->() { return &window_; }

  void open(const QString& path) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    window_.files().open(path);
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  /// Once the 3D view has drawn what was done last.
  QImage picture(const QString& name) {
    QSignalSpy captured(window_.views().viewport, &Viewport::captured);
    window_.views().viewport->capture();
    EXPECT_TRUE(captured.count() > 0 || captured.wait(kPatience));
    QTest::qWait(150);
    EXPECT_TRUE(writeScreenshot(window_, picturePath(name)));
    return QImage(picturePath(name));
  }

 private:
  MainWindow window_;
};

class StudioTour : public testing::Test {
 protected:
  StudioTour() { QSettings().clear(); }
  ~StudioTour() override { QSettings().clear(); }
  QTemporaryDir directory_;
};

int differing(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
  return count;
}

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
  looksDifferent(view.mode[2], "view-wipe");
  looksDifferent(view.swap, "view-wipe-swapped");
  looksDifferent(view.floor, "view-floor");
}

TEST_F(StudioTour, InspectsTheWorstFrame) {
  Studio studio;
  studio.open(sampleClip());
  studio->actions().next_worst->trigger();
  const Distortion& distortion = *studio->session().document().decoded()->distortion;
  EXPECT_EQ(studio->playback().frame(), distortion.max.frame);
  for (const char* id : {"heat-map", "channel", "rate-distortion"}) {
    auto* dock = studio->findChild<QDockWidget*>(QString::fromLatin1(id));
    ASSERT_TRUE(dock);
    dock->raise();
    QTest::qWait(id == std::string("rate-distortion") ? 1500 : 100);
    const QImage picture = studio.picture(QStringLiteral("inspect-") + QString::fromLatin1(id));
    EXPECT_TRUE(dock->widget()->isVisible());
    const QRect area(dock->widget()->mapTo(studio.operator->(), QPoint()), dock->widget()->size());
    std::set<QRgb> colours;
    for (int y = area.top(); y < area.bottom(); y += 2)
      for (int x = area.left(); x < area.right(); x += 2) colours.insert(picture.pixel(x, y));
    EXPECT_GT(colours.size(), 12u) << id;
  }
}

}  // namespace
}  // namespace mocapress
