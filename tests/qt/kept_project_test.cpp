// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/kept_project.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTest>

#include "tests/qt/library_on_disk.h"

namespace mocapress {
namespace {

class AKeptProject : public InALibrary {
 protected:
  static bool holds(const QString& file, const QByteArray& text) {
    QFile written(file);
    return written.open(QIODevice::ReadOnly) && written.readAll().contains(text);
  }

  /// Puts the lock of a studio on another computer in the place of this one's.
  static void takeOverElsewhere(const QString& path) {
    QFile::remove(ProjectLock::fileOf(path));
    QFile lock(ProjectLock::fileOf(path));
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write("1\nmocapress-studio\nelsewhere\n");
  }

  /// Replaces a project by the one of a killed studio, with the lock of a process that is gone.
  static void putBackAsAfterAKill(const QString& crashed, const QString& path) {
    QFile::remove(path);
    ASSERT_TRUE(QFile::rename(crashed, path));
    QFile lock(ProjectLock::fileOf(path));
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write("2147483000\nmocapress-studio\n" + QSysInfo::machineHostName().toUtf8() + "\n");
  }
};

TEST_F(AKeptProject, IsRecoveredWithEditsAndNotesAfterACrash) {
  const QString walk = clip("walk.bvh", 1);
  const QString crashed = path("crashed");
  QString file;
  {
    Run run;
    EXPECT_FALSE(run.library.begin(data()));
    file = run.library.path();
    settleAfter(run, [&] { run.session.open(walk); });
    settleAfter(run, [&] { run.session.setOptions(standardAt(33)); });
    settleAfter(run, [&] { run.session.setContacts({{4, 10, 20}}); });
    run.library.setNote(0, QStringLiteral("look at the wrist"));
    run.library.setVerdict({0}, Verdict::Rejected);
    ASSERT_TRUE(QTest::qWaitFor([&] { return holds(file, "wrist"); }, kPatience));
    ASSERT_TRUE(QFile::copy(file, crashed));
    run.library.end();
  }
  putBackAsAfterAKill(crashed, file);

  Run run;
  QSignalSpy recovered(&run.library, &Library::recovered);
  settleAfter(run, [&] { EXPECT_TRUE(run.library.begin(data())); });
  EXPECT_EQ(recovered.count(), 1);
  EXPECT_DOUBLE_EQ(run.session.document().options().target.value, 33);
  EXPECT_EQ(run.session.document().contacts(), (std::vector<ContactSpan>{{4, 10, 20}}));
  EXPECT_EQ(run.model.entry(0).review.note, "look at the wrist");
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Rejected);
}

TEST_F(AKeptProject, ReopensAfterARegularEndWithoutReportingACrash) {
  const QString walk = clip("walk.bvh", 1);
  {
    Run run;
    run.library.begin(data());
    settleAfter(run, [&] { run.session.open(walk); });
    EXPECT_TRUE(run.library.end());
  }
  Run run;
  QSignalSpy recovered(&run.library, &Library::recovered);
  settleAfter(run, [&] { EXPECT_TRUE(run.library.begin(data())); });
  EXPECT_EQ(recovered.count(), 0);
  EXPECT_EQ(run.session.document().original()->path, walk);
}

TEST_F(AKeptProject, IsOutOfReachWhereTheFilesOfAllItsClipsAreGone) {
  const QString walk = clip("walk.bvh", 1);
  const QString jump = clip("jump.bvh", 2);
  Run run;
  EXPECT_FALSE(run.library.isOutOfReach());
  run.library.add({walk, jump});
  EXPECT_FALSE(run.library.isOutOfReach());
  ASSERT_TRUE(QFile::remove(walk));
  EXPECT_FALSE(run.library.isOutOfReach());
  ASSERT_TRUE(QFile::remove(jump));
  EXPECT_TRUE(run.library.isOutOfReach());
}

TEST_F(AKeptProject, ReopensAfterAnEndTheProjectThatWasInUseWithItsNewestState) {
  const QString knights = path("knights.mocapress");
  {
    Run run;
    run.library.begin(data());
    run.library.add({clip("walk.bvh", 1)});
    ASSERT_TRUE(run.library.saveAs(knights));
    EXPECT_EQ(run.library.name(), QStringLiteral("knights"));
    run.library.setNote(0, QStringLiteral("after Save As"));
    EXPECT_TRUE(run.library.end());
  }
  {
    Run run;
    EXPECT_TRUE(run.library.begin(data()));
    EXPECT_EQ(run.library.path(), knights);
    ASSERT_EQ(run.library.project().clips.size(), 1u);
    EXPECT_EQ(run.library.project().clips[0].review.note, "after Save As");
    EXPECT_TRUE(run.library.startNew());
    EXPECT_TRUE(run.library.end());
  }
  Run run;
  EXPECT_TRUE(run.library.begin(data()));
  EXPECT_TRUE(run.library.project().clips.empty()) << "the new one was in use";
  EXPECT_TRUE(run.library.name().isEmpty());
  EXPECT_TRUE(run.library.open(knights));
  EXPECT_TRUE(run.library.end());
  Run last;
  EXPECT_TRUE(last.library.begin(data()));
  EXPECT_EQ(last.library.path(), knights);
}

TEST_F(AKeptProject, ReopensAfterAKillTheProjectThatWasInUseWithItsNewestState) {
  const QString knights = path("knights.mocapress");
  const QString crashed = path("crashed");
  {
    Run run;
    run.library.begin(data());
    run.library.add({clip("walk.bvh", 1)});
    ASSERT_TRUE(run.library.saveAs(knights));
    run.library.setNote(0, QStringLiteral("after Save As"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return holds(knights, "after Save As"); }, kPatience));
    ASSERT_TRUE(QFile::copy(knights, crashed));
  }
  putBackAsAfterAKill(crashed, knights);
  Run run;
  QSignalSpy recovered(&run.library, &Library::recovered);
  EXPECT_TRUE(run.library.begin(data()));
  EXPECT_EQ(recovered.count(), 1);
  EXPECT_EQ(run.library.path(), knights);
  ASSERT_EQ(run.library.project().clips.size(), 1u);
  EXPECT_EQ(run.library.project().clips[0].review.note, "after Save As");
}

TEST_F(AKeptProject, AProjectReplacedByANewOneCanBeOpenedAgain) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1), clip("jump.bvh", 2)});
  run.library.setNote(0, QStringLiteral("knee"));
  run.library.setVerdict({1}, Verdict::Approved);
  EXPECT_TRUE(run.library.needsName());
  ASSERT_TRUE(run.library.startNew());  // at once, before anything is written
  EXPECT_EQ(run.model.rowCount(), 0);
  EXPECT_FALSE(run.library.needsName());
  const std::vector<FormerProject> former = run.library.formerProjects();
  ASSERT_EQ(former.size(), 1u);
  EXPECT_FALSE(former[0].named);
  EXPECT_EQ(former[0].clips, 2);
  EXPECT_LT(former[0].written.secsTo(QDateTime::currentDateTime()), 3600);
  ASSERT_TRUE(run.library.open(former[0].path));
  ASSERT_EQ(run.library.project().clips.size(), 2u);
  EXPECT_EQ(run.library.project().clips[0].review.note, "knee");
  EXPECT_EQ(run.library.project().clips[1].review.verdict, Verdict::Approved);
  EXPECT_TRUE(run.library.formerProjects().empty()) << "an empty one is not kept";
}

TEST_F(AKeptProject, ASecondStudioBeginsANewProjectAndOpensACopyOfOneInUse) {
  Run first;
  first.library.begin(data());
  first.library.add({clip("walk.bvh", 1)});
  const QString knights = path("knights.mocapress");
  ASSERT_TRUE(first.library.saveAs(knights));
  Run second;
  QSignalSpy noted(&second.library, &Library::noted);
  EXPECT_TRUE(second.library.begin(data()));
  EXPECT_EQ(noted.count(), 1);
  EXPECT_TRUE(second.library.project().clips.empty());
  EXPECT_NE(second.library.path(), knights);
  QSignalSpy in_use(&second.library, &Library::inUse);
  EXPECT_FALSE(second.library.open(knights));
  ASSERT_EQ(in_use.count(), 1);
  EXPECT_FALSE(second.library.saveAs(knights));
  EXPECT_TRUE(second.library.openCopy(knights));
  EXPECT_EQ(second.library.project().clips.size(), 1u);
  EXPECT_NE(second.library.path(), knights);
  EXPECT_TRUE(second.library.name().isEmpty());
}

TEST_F(AKeptProject, ASecondStudioThatDidNothingDoesNotTakeThePlaceOfTheFirst) {
  const QString knights = path("knights.mocapress");
  Run first;
  first.library.begin(data());
  first.library.add({clip("walk.bvh", 1)});
  ASSERT_TRUE(first.library.saveAs(knights));
  Run second;
  second.library.begin(data());
  EXPECT_TRUE(second.library.end());
  EXPECT_TRUE(first.library.end());
  Run next;
  next.library.begin(data());
  EXPECT_EQ(next.library.path(), knights);
}

TEST_F(AKeptProject, DoesNotGoOnWhereTheLastChangesCannotBeWritten) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1)});
  const QString lost = path("lost");
  QDir(directory_.path()).mkpath(QStringLiteral("lost"));
  ASSERT_TRUE(run.library.saveAs(lost + QStringLiteral("/knights.mocapress")));
  // A folder in the file's place makes writing fail, even for the super-user.
  QDir(lost).removeRecursively();
  QDir(directory_.path()).mkpath(QStringLiteral("lost/knights.mocapress/full"));
  run.library.setNote(0, QStringLiteral("still here"));
  QSignalSpy failed(&run.library, &Library::failed);
  EXPECT_FALSE(run.library.startNew());
  EXPECT_EQ(failed.count(), 1);
  EXPECT_TRUE(run.library.stuck());
  EXPECT_FALSE(run.library.open(path("other.mocapress")));
  EXPECT_FALSE(run.library.end());
  ASSERT_EQ(run.library.project().clips.size(), 1u);
  // Saving elsewhere keeps everything.
  const QString found = path("found.mocapress");
  EXPECT_TRUE(run.library.saveAs(found));
  EXPECT_FALSE(run.library.stuck());
  EXPECT_TRUE(holds(found, "still here"));
  EXPECT_TRUE(run.library.end());
}

TEST_F(AKeptProject, AFailedWriteIsReportedOnceAndRetried) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1)});
  const QString knights = path("knights.mocapress");
  ASSERT_TRUE(run.library.saveAs(knights));
  QFile::remove(knights);
  QDir(knights).mkpath(QStringLiteral("full"));
  QSignalSpy failed(&run.library, &Library::failed);
  run.library.setNote(0, QStringLiteral("knee"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return run.library.stuck(); }, kPatience));
  EXPECT_EQ(failed.count(), 1);
  QDir(knights).removeRecursively();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !run.library.stuck(); }, kPatience));
  EXPECT_TRUE(holds(knights, "knee"));
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(AKeptProject, AProjectTakenOverElsewhereIsNotWrittenAnyMore) {
  const QString knights = path("knights.mocapress");
  const QString mine = path("mine.mocapress");
  {
    Run run;
    run.library.begin(data());
    run.library.add({clip("walk.bvh", 1)});
    ASSERT_TRUE(run.library.saveAs(knights));
    takeOverElsewhere(knights);
    QSignalSpy failed(&run.library, &Library::failed);
    run.library.setNote(0, QStringLiteral("knee"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.library.stuck(); }, kPatience));
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("elsewhere")));
    EXPECT_FALSE(run.library.end()) << "the window asks whether to quit without the changes";
    EXPECT_FALSE(run.library.saveAs(knights)) << "it would overwrite the other's work";
    EXPECT_FALSE(holds(knights, "knee"));
    failed.clear();
    EXPECT_TRUE(run.library.saveAs(mine));
    EXPECT_EQ(failed.count(), 0) << "nothing is lost any more";
    EXPECT_TRUE(holds(mine, "knee"));
    run.library.setNote(0, QStringLiteral("elbow"));
  }
  EXPECT_TRUE(holds(mine, "elbow"));
  EXPECT_FALSE(holds(knights, "knee"));
  EXPECT_TRUE(holds(ProjectLock::fileOf(knights), "elsewhere")) << "the lock of the new owner";
}

TEST_F(AKeptProject, AnUnnamedProjectTakenOverElsewhereStaysInItsFile) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1)});
  const QString unnamed = run.library.path();
  ASSERT_TRUE(QTest::qWaitFor([&] { return holds(unnamed, "walk"); }, kPatience));
  takeOverElsewhere(unnamed);
  EXPECT_TRUE(run.library.saveAs(path("mine.mocapress")));
  EXPECT_TRUE(holds(unnamed, "walk")) << "the other studio works on it";
}

TEST_F(AKeptProject, AStartSaysOnWhichComputerTheLastProjectIsOpen) {
  const QString knights = path("knights.mocapress");
  {
    Run run;
    run.library.begin(data());
    run.library.add({clip("walk.bvh", 1)});
    ASSERT_TRUE(run.library.saveAs(knights));
    EXPECT_TRUE(run.library.end());
  }
  takeOverElsewhere(knights);
  Run run;
  QSignalSpy noted(&run.library, &Library::noted);
  EXPECT_TRUE(run.library.begin(data()));
  ASSERT_EQ(noted.count(), 1);
  EXPECT_TRUE(noted[0][0].toString().contains(QStringLiteral("on the computer elsewhere")));
  EXPECT_FALSE(noted[0][0].toString().contains(QStringLiteral("window")));
}

TEST_F(AKeptProject, ReportsAMissingOrUnreadableProjectAndBeginsANewOne) {
  const QString knights = path("knights.mocapress");
  {
    Run run;
    run.library.begin(data());
    run.library.add({clip("walk.bvh", 1)});
    ASSERT_TRUE(run.library.saveAs(knights));
    EXPECT_TRUE(run.library.end());
  }
  for (const bool there : {false, true}) {
    QFile::remove(knights);
    QFile file(knights);
    if (there) {
      ASSERT_TRUE(file.open(QIODevice::WriteOnly));
      file.write("{\"format\": ");
      file.close();
    }
    Run run;
    QSignalSpy failed(&run.library, &Library::failed);
    EXPECT_TRUE(run.library.begin(data()));
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("knights")));
    EXPECT_TRUE(run.library.name().isEmpty());
    EXPECT_EQ(QFile::exists(knights), there) << "left as it is";
  }
}

TEST_F(AKeptProject, TheQueueOfABatchGoesWithItsProject) {
  Run run;
  run.library.begin(data());
  const QString knights = path("knights.mocapress");
  ASSERT_TRUE(run.library.saveAs(knights));
  RememberedBatch batch;
  batch.settings.folder = path("out");
  batch.clips = {{.source = {clip("walk.bvh", 1).toStdString(), "moves", {}}}};
  bool asked = false;
  run.library.setLeaveCheck([&] {
    if (!std::exchange(asked, true)) run.library.setBatch(batch);
    return QString();
  });
  ASSERT_TRUE(run.library.startNew());
  EXPECT_FALSE(run.library.project().batch);
  ASSERT_TRUE(run.library.open(knights));
  ASSERT_TRUE(run.library.project().batch);
  EXPECT_EQ(run.library.project().batch->settings, batch.settings);
  EXPECT_EQ(run.library.project().batch->clips[0].source, batch.clips[0].source);
}

TEST_F(AKeptProject, AProjectIsNotLeftWhileItsLeaveCheckRefuses) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1)});
  run.library.setLeaveCheck([] { return QStringLiteral("its batch is running"); });
  QSignalSpy failed(&run.library, &Library::failed);
  EXPECT_FALSE(run.library.startNew());
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed[0][0].toString(), QStringLiteral("its batch is running"));
  EXPECT_EQ(run.library.project().clips.size(), 1u);
  EXPECT_TRUE(run.library.end()) << "the program ends all the same";
}

TEST_F(AKeptProject, AChangeOfFileLosesNothingOfTheOneBefore) {
  const QString a = path("a.mocapress");
  const QString b = path("b.mocapress");
  Run run;
  run.library.begin(data());
  ASSERT_TRUE(run.library.saveAs(a));
  run.library.add({clip("walk.bvh", 1)});
  // Saves at once, while a write to the first file is pending.
  ASSERT_TRUE(run.library.saveAs(b));
  run.library.add({clip("jump.bvh", 2)});
  ASSERT_TRUE(run.library.open(a));
  EXPECT_EQ(run.library.project().clips.size(), 1u);
  ASSERT_TRUE(run.library.open(b));
  EXPECT_EQ(run.library.project().clips.size(), 2u);
}

}  // namespace
}  // namespace mocapress
