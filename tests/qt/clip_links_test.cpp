// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/clip_links.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

class LinksToClips : public testing::Test {
 protected:
  /// A studio without its window, whose playback follows the clip as the presenter has it.
  struct Studio {
    Session session;
    LibraryModel model;
    Library library{&session, &model};
    Playback playback;
    Viewport viewport;
    ClipLinks links{&session, &library, &playback, &viewport, nullptr};
    Studio() {
      QObject::connect(&session.document(), &Document::clipChanged, &playback,
                       [this] { playback.setClip(session.document().frames(), 30); });
    }

    void open(const std::function<void()>& act) {
      QSignalSpy opened(&session, &Session::opened);
      act();
      ASSERT_TRUE(opened.count() > 0 || opened.wait(kPatience));
    }
  };

  QString clip(const char* name, unsigned seed) const {
    const QString path = QDir(directory_.path()).filePath(QLatin1String(name));
    write_motion(path.toStdU16String(), test::smooth_motion(120, seed));
    return path;
  }

  QTemporaryDir directory_;
};

TEST_F(LinksToClips, LeadToFrameJointAndViewInAnotherStudio) {
  Studio here;
  here.open([&] { here.session.open(clip("a walk & more.bvh", 1)); });
  here.playback.seek(70);
  here.session.document().setCurrentJoint(here.session.document().skeleton()->find("lhand"));
  here.viewport.setCameraPlace({{10, 9, -5}, 300, 2.1f, 0.4f});
  const QString link = here.links.toHere();
  EXPECT_TRUE(ClipLinks::isLink(link));

  Studio there;
  there.open([&] { there.session.open(clip("other.bvh", 2)); });
  there.open([&] { there.links.open(link); });
  EXPECT_EQ(there.session.document().title(), QStringLiteral("a walk & more.bvh"));
  EXPECT_EQ(there.playback.frame(), 70);
  EXPECT_EQ(there.session.document().currentJoint(),
            there.session.document().skeleton()->find("lhand"));
  const OrbitCamera::Place place = there.viewport.cameraPlace();
  EXPECT_NEAR(place.target.y(), 9, 0.1);
  EXPECT_NEAR(place.azimuth, 2.1, 0.01);
  EXPECT_NEAR(place.elevation, 0.4, 0.01);
}

TEST_F(LinksToClips, FindTheClipOfThatNameWhereThePathIsAnothersOwn) {
  Studio studio;
  const QString path = clip("walk.bvh", 1);
  studio.library.add({path});
  QSignalSpy failed(&studio.links, &ClipLinks::failed);
  studio.open([&] {
    studio.links.open(QStringLiteral("mocapress://open?clip=/somebody/elses/walk.bvh&frame=5000"));
  });
  EXPECT_EQ(studio.session.document().original()->path, path);
  EXPECT_EQ(studio.playback.frame(), 119) << "the last: the clip is shorter than the link says";
  EXPECT_EQ(failed.count(), 0);
  studio.links.open(QStringLiteral("mocapress://open?clip=/somebody/elses/run.bvh"));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("run.bvh")));
}

TEST_F(LinksToClips, OpenNothingDangerous) {
  Studio studio;
  QSignalSpy failed(&studio.links, &ClipLinks::failed), opening(&studio.session, &Session::opening);
  for (const char* link : {"mocapress://open?clip=//server/share/walk.bvh",
                           "mocapress://open?clip=/etc/passwd", "mocapress:run"})
    studio.links.open(QLatin1String(link));
  EXPECT_EQ(failed.count(), 3);
  EXPECT_EQ(opening.count(), 0);
}

}  // namespace
}  // namespace mocapress
