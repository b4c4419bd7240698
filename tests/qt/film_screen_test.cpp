// SPDX-License-Identifier: GPL-3.0-or-later
// Films of the 3D view. Needs an X display with OpenGL (Xvfb is enough).
#include "app/studio/compare/film_recorder.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/compare/view_pictures.h"
#include "app/studio/document/session.h"
#include "core/motion/landmarks.h"
#include "tests/qt/patience.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

class FilmScreen : public testing::Test {
 protected:
  void SetUp() override {
    viewport_.resize(321, 201);  // odd, as windows may be
    viewport_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&viewport_));
    Skeleton skeleton;
    Joint foot;
    foot.parent = -1;
    foot.channels = {ChannelKind::TranslationX};
    skeleton.add(foot);
    Joint head;
    head.parent = 0;
    head.offset = {0, 100, 0};
    skeleton.add(head);
    Clip clip;
    clip.channels = Eigen::VectorXd::LinSpaced(10, 0, 45);
    viewport_.setSkeleton(skeleton);
    viewport_.setOriginal(std::make_shared<const Eigen::MatrixXd>(landmark_tracks(skeleton, clip)));
  }

  Film walk() {
    return {4, 30, [this](int picture) { viewport_.setFrame(3 * picture); }};
  }

  QString path(const QString& name) const { return directory_.filePath(name); }
  QStringList files() const {
    return QDir(directory_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
  }

  QTemporaryDir directory_;
  Viewport viewport_;
  FilmRecorder recorder_{&viewport_};
};

TEST_F(FilmScreen, WritesNumberedPicturesIntoAFolder) {
  QSignalSpy finished(&recorder_, &FilmRecorder::finished);
  recorder_.record(walk(), path(QStringLiteral("walk.png")));
  ASSERT_TRUE(finished.wait(kPatience));
  EXPECT_EQ(files(), QStringList(QStringLiteral("walk")));
  const QImage first(path(QStringLiteral("walk/walk_0001.png")));
  const QImage last(path(QStringLiteral("walk/walk_0004.png")));
  EXPECT_EQ(first.size(), QSize(321, 201));
  EXPECT_NE(first, last);
  EXPECT_FALSE(QFile::exists(path(QStringLiteral("walk/walk_0005.png"))));
}

TEST_F(FilmScreen, PicturesThatAreAskedForTogetherAreAllWritten) {
  Session session;
  Playback playback;
  QSignalSpy captured(&viewport_, &Viewport::captured);
  {
    ViewPictures pictures(&session, &playback, &viewport_, &viewport_);
    for (const char* name : {"a.png", "b.png", "c.png"})
      pictures.savePicture(path(QString::fromLatin1(name)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return captured.count() == 3; }, kPatience));
  }
  EXPECT_EQ(files(), (QStringList{QStringLiteral("a.png"), QStringLiteral("b.png"),
                                  QStringLiteral("c.png")}));
}

TEST_F(FilmScreen, WritesAVideoWhereThereIsFfmpeg) {
  QSignalSpy finished(&recorder_, &FilmRecorder::finished);
  QSignalSpy failed(&recorder_, &FilmRecorder::failed);
  recorder_.record(walk(), path(QStringLiteral("50 % walk.mp4")));
  if (FilmRecorder::ffmpeg().isEmpty()) {
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("ffmpeg")));
    EXPECT_TRUE(files().isEmpty());
    return;
  }
  ASSERT_TRUE(finished.wait(kPatience));
  EXPECT_EQ(files(), QStringList(QStringLiteral("50 % walk.mp4")));
  EXPECT_GT(QFileInfo(path(QStringLiteral("50 % walk.mp4"))).size(), 500);
}

TEST_F(FilmScreen, LeavesNothingWhenItIsCancelled) {
  QObject::connect(&recorder_, &FilmRecorder::progressed, [this](int pictures) {
    if (pictures == 2) recorder_.cancel();
  });
  QSignalSpy progressed(&recorder_, &FilmRecorder::progressed);
  recorder_.record(walk(), path(QStringLiteral("walk.png")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !recorder_.busy(); }, kPatience));
  EXPECT_TRUE(files().isEmpty()) << qPrintable(files().join(u' '));
}

TEST_F(FilmScreen, RefusesAFolderThatIsThereAlready) {
  QDir(directory_.path()).mkdir(QStringLiteral("walk"));
  QSignalSpy failed(&recorder_, &FilmRecorder::failed);
  recorder_.record(walk(), path(QStringLiteral("walk.png")));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(files(), QStringList(QStringLiteral("walk")));
}

}  // namespace
}  // namespace mocapress
