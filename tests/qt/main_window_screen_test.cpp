// SPDX-License-Identifier: GPL-3.0-or-later
// The whole studio on a screen. Needs an X display with OpenGL (Xvfb is enough).
#include "app/studio/window/main_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/studio/document/clip_files.h"
#include "app/studio/window/screenshot.h"
#include "app/studio/window/trace.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/qt/studio_at_work.h"
#include "tests/support/test_motion.h"
#include "widgets/panels/compression_panel.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/target_control.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

bool isBrightRed(QRgb pixel) {
  return qRed(pixel) > 90 && qRed(pixel) > 2 * qGreen(pixel) && qRed(pixel) > 2 * qBlue(pixel);
}

int redPixels(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += isBrightRed(image.pixel(x, y));
  return count;
}

class MainWindowTest : public testing::Test {
 protected:
  MainWindowTest() {
    QSettings().clear();
    window_.resize(1200, 800);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }

  ~MainWindowTest() override { QSettings().clear(); }

  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }

  QString writeClip(const char* name, int frames) const {
    write_motion(path(name).toStdU16String(), test::smooth_motion(frames));
    return path(name);
  }

  void openAndSettle(const QString& file) {
    QSignalSpy settled(&window_.session(), &Session::settled);
    window_.files().open(file);
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  QImage capture() {
    QSignalSpy captured(viewport_, &Viewport::captured);
    viewport_->capture();
    return captured.count() > 0 || captured.wait(kPatience) ? captured[0][0].value<QImage>()
                                                            : QImage();
  }

  QTemporaryDir directory_;
  MainWindow window_;
  Viewport* viewport_ = window_.views().viewport;
  Document& document_ = window_.session().document();
};

using StudioWindow = MainWindowTest;

TEST_F(StudioWindow, ShowsBothFiguresOfTheSampleAfterADragAndSavesWhatItShows) {
  ASSERT_FALSE(sampleClip().isEmpty());
  openAndSettle(sampleClip());
  QSignalSpy settled(&window_.session(), &Session::settled);
  QSlider* slider = window_.views().compression->target()->slider();
  for (int position = slider->value(); position < 900; position += 20) {
    slider->setValue(position);
    runDueEvents();
  }
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_GT(document_.decoded()->ratio, 80);
  EXPECT_TRUE(window_.isWindowModified());
  window_.playback().seek(document_.frames() / 2);

  const QImage both = capture();
  EXPECT_GT(redPixels(both), 200);
  viewport_->setOriginal(nullptr);
  EXPECT_GT(test::differing(both, capture()), 200) << "the ghost of the original";
  viewport_->setCompressed(nullptr);
  EXPECT_EQ(redPixels(capture()), 0);

  QSignalSpy saved(&window_.session(), &Session::saved);
  window_.session().save(path("walk.mcpr"));
  ASSERT_TRUE(saved.wait(kPatience));
  EXPECT_FALSE(window_.isWindowModified());

  MainWindow other;
  other.show();
  QSignalSpy opened(&other.session(), &Session::settled);
  other.files().open(path("walk.mcpr"));
  ASSERT_TRUE(opened.wait(kPatience));
  const Eigen::MatrixXd& reopened = *other.session().document().decoded()->tracks;
  EXPECT_LT((reopened - *document_.decoded()->tracks).cwiseAbs().maxCoeff(), 1e-3);  // cm
  EXPECT_TRUE(other.windowTitle().startsWith(QStringLiteral("walk.mcpr")));
}

TEST_F(StudioWindow, ASliderMovementIsFollowedByAPictureSoon) {
  openAndSettle(writeClip("motion.bvh", 2000));
  window_.trace().setWriting(true);
  std::vector<double> milliseconds;
  QObject::connect(&window_.trace(), &Trace::sliderToPicture,
                   [&](double passed) { milliseconds.push_back(passed); });
  QSlider* slider = window_.views().compression->target()->slider();
  constexpr std::size_t kMovements = 9;
  while (milliseconds.size() < kMovements) {
    const std::size_t before = milliseconds.size();
    slider->setValue(slider->value() + 13);
    ASSERT_TRUE(QTest::qWaitFor([&] { return milliseconds.size() > before; }, kPatience));
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("slider-to-picture: 2000 frames, %zu movements: median %.1f ms, worst %.1f ms\n",
              milliseconds.size(), milliseconds[kMovements / 2], milliseconds.back());
  EXPECT_LT(milliseconds[kMovements / 2], 2000);  // generous, since machines differ
}

TEST_F(StudioWindow, IsNotAwayForLongWhileALongClipIsCompressed) {
  constexpr int kFrames = 2000;
  Motion motion = read_motion(sampleClip().toStdU16String()).motion;
  const Eigen::MatrixXd walk = motion.clip.channels;
  motion.clip.channels.resize(kFrames, walk.cols());
  for (int frame = 0; frame < kFrames; ++frame)
    motion.clip.channels.row(frame) = walk.row(frame % walk.rows());
  write_motion(path("long.bvh").toStdU16String(), motion);
  openAndSettle(path("long.bvh"));
  window_.trace().setWriting(true);
  runDueEvents();
  window_.trace().takeLongestBlock();
  QSlider* slider = window_.views().compression->target()->slider();
  for (int step = 0; step < 20; ++step) {
    slider->setValue(slider->value() + 9);
    runDueEvents();
  }
  // The draft of the last step and a part of its refinement: the rest would be more of the same.
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.session().refining(); }, kPatience));
  window_.session().cancelAnnealing();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.session().busy(); }, kPatience));
  const Trace::Block longest = window_.trace().takeLongestBlock();
  std::printf(
      "%d frames of a body of 31 joints: longest time away from events %.1f ms, most work at a "
      "time %.1f ms\n",
      kFrames, longest.away, longest.worked);
  EXPECT_LT(longest.worked, 200);  // 0.1 ms a frame: generous, since machines differ
}

TEST_F(StudioWindow, AnUnreadableFileIsAMessageInTheWindow) {
  writeClip("motion.amc", 60);
  QFile::remove(path("motion.asf"));
  QSignalSpy failed(&window_.session(), &Session::openFailed);
  window_.files().open(path("motion.amc"));
  ASSERT_TRUE(failed.wait(kPatience));
  EXPECT_TRUE(window_.messages().isVisible());
  EXPECT_FALSE(window_.messages().text().isEmpty());
  openAndSettle(writeClip("motion.bvh", 60));
  EXPECT_FALSE(window_.messages().isVisible());
}

TEST_F(StudioWindow, OpensWhatIsDroppedOnIt) {
  QSignalSpy settled(&window_.session(), &Session::settled);
  test::drop(window_, {QUrl::fromLocalFile(writeClip("dropped.bvh", 80))});
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_EQ(document_.frames(), 80);
}

TEST_F(StudioWindow, DroppedFilesCountOnlyAsMotionsAndASingleOneIsOpened) {
  QFile notes(path("notes.txt"));
  ASSERT_TRUE(notes.open(QIODevice::WriteOnly));
  QSignalSpy settled(&window_.session(), &Session::settled);
  test::drop(window_, {QUrl::fromLocalFile(notes.fileName()),
                       QUrl::fromLocalFile(writeClip("dropped.bvh", 70)),
                       QUrl(QStringLiteral("https://example.org/walk.bvh"))});
  ASSERT_TRUE(settled.wait(kPatience));
  EXPECT_EQ(document_.frames(), 70);
}

TEST_F(StudioWindow, KeysPlayAndStep) {
  openAndSettle(writeClip("motion.bvh", 120));
  Playback& playback = window_.playback();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  QTest::keyClick(&window_, Qt::Key_End);
  EXPECT_EQ(playback.frame(), 119);
  QTest::keyClick(&window_, Qt::Key_Left);
  EXPECT_EQ(playback.frame(), 118);
  QTest::keyClick(&window_, Qt::Key_Home);
  EXPECT_EQ(playback.frame(), 0);
  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_TRUE(playback.playing());
  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_FALSE(playback.playing());
}

TEST_F(StudioWindow, AClickOnAJointDrawsItsCurve) {
  openAndSettle(writeClip("motion.bvh", 80));
  document_.setCurves({});
  emit viewport_->jointClicked(2);
  const QString name = QString::fromStdString(document_.skeleton()->joint(2).name);
  EXPECT_TRUE(document_.curves().contains(name));
  EXPECT_EQ(document_.currentJoint(), 2);
  emit viewport_->jointClicked(2);
  EXPECT_FALSE(document_.curves().contains(name));
}

TEST_F(StudioWindow, WritesAPictureOfItself) {
  openAndSettle(writeClip("motion.bvh", 80));
  ASSERT_TRUE(writeScreenshot(window_, path("window.png")));
  const QImage picture(path("window.png"));
  EXPECT_EQ(picture.size(), window_.frameGeometry().size() * window_.devicePixelRatio());
  EXPECT_FALSE(writeScreenshot(window_, path("no/such/directory/window.png")));
}

}  // namespace
}  // namespace mocapress
