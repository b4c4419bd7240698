// SPDX-License-Identifier: GPL-3.0-or-later
// Files of clips that change, go and come back.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include "tests/qt/library_on_disk.h"

namespace mocapress {
namespace {

TEST_F(InALibrary, TheOpenClipIsReadAgainWhenItsFileHasChanged) {
  Run run;
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  run.library.setVerdict({0}, Verdict::Approved);
  const OriginalPtr before = run.session.document().original();
  clip("walk.bvh", 3);
  settleAfter(run, [&] { run.library.checkFiles(); });
  EXPECT_NE(run.session.document().original(), before);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Source);
}

TEST_F(InALibrary, AChangedFileThatCannotBeReadIsOpenedOnceForEachContent) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  const auto damage = [&](const char* text) {
    QFile file(walk);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  QSignalSpy failures(&run.session, &Session::openFailed);
  QSignalSpy looks(&run.library, &Library::looked);
  const auto look = [&] {
    const auto before = looks.size();
    run.library.checkFiles();
    QTRY_COMPARE_WITH_TIMEOUT(looks.size(), before + 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!run.session.isOpening(), kPatience);
  };
  damage("HIERARCHY");
  look();
  look();
  look();
  EXPECT_EQ(failures.size(), 1);
  damage("HIERARCHY ROOT");
  look();
  look();
  EXPECT_EQ(failures.size(), 2);
}

TEST_F(InALibrary, AClipWhoseFileIsGoneIsNotShownAndGetsNoVerdict) {
  Run run;
  const QString jump = clip("jump.bvh", 2);
  run.library.add({clip("walk.bvh", 1), jump});
  settleAfter(run, [&] { run.library.openClip(0); });
  ASSERT_TRUE(QFile::remove(jump));
  QSignalSpy open_failed(&run.session, &Session::openFailed);
  run.library.openClip(1);
  ASSERT_TRUE(open_failed.wait(kPatience));
  EXPECT_FALSE(run.session.document().original()) << "not the clip before";
  EXPECT_EQ(run.library.currentRow(), 1);
  EXPECT_TRUE(run.model.entry(1).missing);
  QSignalSpy failed(&run.library, &Library::failed);
  run.library.setVerdict({0, 1}, Verdict::Approved);
  EXPECT_EQ(failed.count(), 1);
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Approved);
  EXPECT_EQ(run.model.entry(1).review.verdict, Verdict::None);
}

TEST_F(InALibrary, AMissingFileMakesAVerdictStaleUntilItIsBack) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  run.library.setVerdict({0}, Verdict::Rejected);
  ASSERT_TRUE(QFile::rename(walk, path("aside")));
  run.library.checkFiles();
  QTRY_COMPARE_WITH_TIMEOUT(run.model.entry(0).stale, Staleness::Missing, kPatience);
  ASSERT_TRUE(QFile::rename(path("aside"), walk));
  run.library.checkFiles();
  QTRY_COMPARE_WITH_TIMEOUT(run.model.entry(0).stale, Staleness::None, kPatience);
}

TEST_F(InALibrary, MissingClipsAreFoundByNameAndBytesInOneStep) {
  QDir(directory_.path()).mkpath(QStringLiteral("new/other"));
  Run run;
  const QString a = clip("a.bvh", 1), b = clip("b.bvh", 2), c = clip("c.bvh", 3);
  run.library.add({a, b, c});
  run.library.setVerdict({0}, Verdict::Approved);
  QTRY_VERIFY_WITH_TIMEOUT(!run.library.project().clips[2].stamp.hash.empty(), kPatience);
  // Two files have the missing one's name; the bytes decide. One of the missing clips has only
  // another version.
  ASSERT_TRUE(QFile::rename(a, path("new/other/a.bvh")));
  clip("new/a.bvh", 9);
  ASSERT_TRUE(QFile::remove(b));
  clip("new/b.bvh", 8);
  ASSERT_TRUE(QFile::remove(c));
  run.library.checkFiles();
  QTRY_VERIFY_WITH_TIMEOUT(run.model.entry(2).missing, kPatience);
  QSignalSpy noted(&run.library, &Library::noted);
  run.library.findMissing(path("new"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return noted.count() > 0; }, kPatience));
  EXPECT_EQ(noted[0][0].toString(), QStringLiteral("Found 2 clip(s), 1 still missing"));
  EXPECT_EQ(run.model.entry(0).path, path("new/other/a.bvh"));
  EXPECT_EQ(run.model.entry(0).stale, Staleness::None) << "it is the file that was approved";
  EXPECT_EQ(run.model.entry(1).path, path("new/b.bvh"));
  EXPECT_EQ(run.model.entry(2).path, c);
  run.library.history()->undo();
  EXPECT_EQ(run.model.entry(0).path, a);
  EXPECT_EQ(run.model.entry(1).path, b);
}

}  // namespace
}  // namespace mocapress
