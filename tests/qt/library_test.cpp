// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include "app/jobs/batch_runner.h"
#include "app/studio/document/session.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

EncodeSettings standard(double ratio) {
  return {.method = Method::Standard, .target = {Target::Kind::Ratio, ratio}};
}

class InALibrary : public testing::Test {
 protected:
  /// One run of the studio without its window.
  struct Run {
    Session session;
    LibraryModel model;
    Library library{&session, &model};
    Run() { session.setOptions(standard(10)); }
  };

  QString clip(const char* name, unsigned seed) const {
    write_motion(path(name).toStdU16String(), test::smooth_motion(120, seed));
    return path(name);
  }

  template <typename Act>
  static void settleAfter(Run& run, Act act) {
    QSignalSpy settled(&run.session, &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  /// The folder of the studio's data.
  QString data() const { return path("data"); }

  QString path(const char* name) const {
    return QDir(QDir(directory_.path()).canonicalPath()).filePath(QString::fromLatin1(name));
  }

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

  QTemporaryDir directory_;
};

TEST_F(InALibrary, EveryClipHasItsOwnSettings) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  const QString jump = clip("jump.bvh", 2);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standard(20)); });
  settleAfter(run, [&] { run.session.open(jump); });
  settleAfter(run, [&] { run.session.setOptions(standard(40)); });
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_DOUBLE_EQ(run.session.document().options().target.value, 20);
  settleAfter(run, [&] { run.library.openClip(1); });
  EXPECT_DOUBLE_EQ(run.session.document().options().target.value, 40);
  EXPECT_NEAR(run.model.entry(0).outcome->ratio, 20, 0.5);
  EXPECT_TRUE(run.model.entry(1).outcome->met);
}

TEST_F(InALibrary, IsRecoveredWithEditsAndNotesAfterACrash) {
  const QString walk = clip("walk.bvh", 1);
  const QString crashed = path("crashed");
  QString file;
  {
    Run run;
    EXPECT_FALSE(run.library.begin(data()));
    file = run.library.path();
    settleAfter(run, [&] { run.session.open(walk); });
    settleAfter(run, [&] { run.session.setOptions(standard(33)); });
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

TEST_F(InALibrary, ReopensAfterARegularEndWithoutReportingACrash) {
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

TEST_F(InALibrary, IsOutOfReachWhereTheFilesOfAllItsClipsAreGone) {
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

TEST_F(InALibrary, ReopensAfterAnEndTheProjectThatWasInUseWithItsNewestState) {
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

TEST_F(InALibrary, ReopensAfterAKillTheProjectThatWasInUseWithItsNewestState) {
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

TEST_F(InALibrary, AProjectReplacedByANewOneCanBeOpenedAgain) {
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

TEST_F(InALibrary, NewClosesTheClipThatIsOpenAndTheOneOnItsWay) {
  Run run;
  run.library.begin(data());
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  run.session.open(clip("jump.bvh", 2));
  ASSERT_TRUE(run.library.startNew());
  EXPECT_FALSE(run.session.document().original());
  EXPECT_FALSE(run.session.document().decoded());
  settleAfter(run, [&] { run.session.open(clip("run.bvh", 3)); });
  ASSERT_EQ(run.library.project().clips.size(), 1u);
  EXPECT_TRUE(run.library.project().clips[0].path.endsWith(QStringLiteral("run.bvh")));
}

TEST_F(InALibrary, ASecondStudioBeginsANewProjectAndOpensACopyOfOneInUse) {
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

TEST_F(InALibrary, ASecondStudioThatDidNothingDoesNotTakeThePlaceOfTheFirst) {
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

TEST_F(InALibrary, DoesNotGoOnWhereTheLastChangesCannotBeWritten) {
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

TEST_F(InALibrary, AFailedWriteIsReportedOnceAndRetried) {
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

TEST_F(InALibrary, AProjectTakenOverElsewhereIsNotWrittenAnyMore) {
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

TEST_F(InALibrary, AnUnnamedProjectTakenOverElsewhereStaysInItsFile) {
  Run run;
  run.library.begin(data());
  run.library.add({clip("walk.bvh", 1)});
  const QString unnamed = run.library.path();
  ASSERT_TRUE(QTest::qWaitFor([&] { return holds(unnamed, "walk"); }, kPatience));
  takeOverElsewhere(unnamed);
  EXPECT_TRUE(run.library.saveAs(path("mine.mocapress")));
  EXPECT_TRUE(holds(unnamed, "walk")) << "the other studio works on it";
}

TEST_F(InALibrary, AStartSaysOnWhichComputerTheLastProjectIsOpen) {
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

TEST_F(InALibrary, ReportsAMissingOrUnreadableProjectAndBeginsANewOne) {
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

TEST_F(InALibrary, AVerdictNamesWhatWasReviewedByWhomAndWhen) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  run.library.setVerdict({0}, Verdict::Approved);
  const ProjectClip& reviewed = run.library.project().clips[0];
  EXPECT_EQ(reviewed.review.source_hash, hash_of(walk.toStdU16String()));
  EXPECT_EQ(reviewed.review.settings_hash, settings_hash(reviewed.settings->preset, {}));
  EXPECT_FALSE(reviewed.review.reviewer.empty());
  const QDateTime given =
      QDateTime::fromString(QString::fromStdString(reviewed.review.time), Qt::ISODate);
  EXPECT_LE(std::abs(given.secsTo(QDateTime::currentDateTimeUtc())), 3600);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::None);
}

TEST_F(InALibrary, OtherSettingsMakeAVerdictStaleUntilTheyAreTakenBack) {
  Run run;
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  run.library.setVerdict({0}, Verdict::Approved);
  settleAfter(run, [&] { run.session.setOptions(standard(50)); });
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Approved);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Settings);
  settleAfter(run, [&] { run.session.history()->undo(); });
  EXPECT_EQ(run.model.entry(0).stale, Staleness::None);
}

TEST_F(InALibrary, RemarksAreTheVerdictWithWhatMakesItStaleAndTheNote) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  EXPECT_TRUE(run.library.remarksOn(walk).empty());
  run.library.setNote(0, QStringLiteral("look at the wrist"));
  run.library.setVerdict({0}, Verdict::Approved);
  const std::vector<std::string> remarks = run.library.remarksOn(walk);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_TRUE(remarks[0].starts_with("approved by ")) << remarks[0];
  EXPECT_EQ(remarks[0].find("stale"), std::string::npos);
  EXPECT_EQ(remarks[1], "look at the wrist");
  settleAfter(run, [&] { run.session.setOptions(standard(50)); });
  EXPECT_TRUE(run.library.remarksOn(walk)[0].ends_with("stale: the settings changed"));
}

TEST_F(InALibrary, AVerdictDoesNotTravelWithAFileThatWasReplaced) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  run.library.setVerdict({0}, Verdict::Approved);
  settleAfter(run, [&] { run.session.open(clip("jump.bvh", 2)); });
  clip("walk.bvh", 3);
  run.library.checkFiles();
  QTRY_COMPARE_WITH_TIMEOUT(run.model.entry(0).stale, Staleness::Source, kPatience);
  EXPECT_EQ(run.model.entry(0).outdated, Staleness::Source);
  // A verdict on the old figures, which are still shown, does not apply to the new file.
  run.library.setVerdict({0}, Verdict::Approved);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Source);
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_EQ(run.model.entry(0).outdated, Staleness::None);
  run.library.setVerdict({0}, Verdict::Approved);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::None);
}

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

TEST_F(InALibrary, AVerdictWithoutHashesIsStaleAsUnknown) {
  clip("walk.bvh", 1);
  QFile file(path("old.mocapress"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"format": "mocapress-project", "version": 1,
                 "clips": [{"path": "walk.bvh", "verdict": "approved"}]})");
  file.close();
  Run run;
  run.library.open(file.fileName());
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Unknown);
  QTRY_VERIFY_WITH_TIMEOUT(!run.library.project().clips[0].stamp.hash.empty(), kPatience);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Unknown);
}

TEST_F(InALibrary, AVerdictOfASelectionIsOneStep) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2), clip("c.bvh", 3)});
  run.library.setVerdict({0, 1, 2}, Verdict::Approved);
  for (int row = 0; row < 3; ++row)
    EXPECT_EQ(run.model.entry(row).review.verdict, Verdict::Approved) << row;
  // Files are checked in the background; verdicts are about their earlier contents.
  for (int row = 0; row < 3; ++row)
    QTRY_COMPARE_WITH_TIMEOUT(run.model.entry(row).stale, Staleness::None, kPatience);
  run.library.history()->undo();
  for (int row = 0; row < 3; ++row)
    EXPECT_EQ(run.model.entry(row).review.verdict, Verdict::None) << row;
  EXPECT_EQ(run.model.rowCount(), 3);
}

TEST_F(InALibrary, APresetOfASelectionIsOneStepAndReachesTheOpenClip) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2), clip("c.bvh", 3)});
  settleAfter(run, [&] { run.library.openClip(0); });
  const EncodeSettings before = run.session.document().options();
  const Settings& crowd = built_in_presets()[3];
  settleAfter(run, [&] { run.library.setPreset({0, 1}, crowd); });
  EXPECT_EQ(run.session.document().options().target, crowd.target);
  EXPECT_EQ(run.library.project().clips[1].settings->preset, crowd);
  EXPECT_FALSE(run.library.project().clips[2].settings);
  settleAfter(run, [&] { run.library.history()->undo(); });
  EXPECT_EQ(run.session.document().options().target, before.target);
  EXPECT_FALSE(run.library.project().clips[1].settings);
}

/// Opening must not change settings, or a verdict would become stale at once.
TEST_F(InALibrary, OpeningAClipDoesNotChangeTheSettingsItHas) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2)});
  for (const Settings& preset : built_in_presets()) {
    run.library.setPreset({0, 1}, preset);
    for (const int row : {0, 1}) settleAfter(run, [&] { run.library.openClip(row); });
    run.library.setVerdict({0, 1}, Verdict::Approved);
    for (const int row : {0, 1}) {
      settleAfter(run, [&] { run.library.openClip(row); });
      EXPECT_EQ(run.library.project().clips[static_cast<std::size_t>(row)].settings->preset,
                preset);
      EXPECT_EQ(run.model.entry(row).stale, Staleness::None) << preset.name;
    }
    // A setting chosen for the open clip equals one chosen in the library or for a batch.
    settleAfter(run, [&] { run.session.setOptions(standard(17)); });
    settleAfter(run, [&] { run.session.choosePreset(preset); });
    EXPECT_EQ(run.library.project().clips[1].settings->preset, preset);
  }
}

TEST_F(InALibrary, AVerdictIsAboutTheFiguresThatTheRowShows) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2)});
  for (const int row : {0, 1}) settleAfter(run, [&] { run.library.openClip(row); });
  settleAfter(run, [&] { run.library.setPreset({0, 1}, built_in_presets()[3]); });
  EXPECT_EQ(run.model.entry(0).outdated, Staleness::Settings) << "not compressed by these yet";
  run.library.setVerdict({0, 1}, Verdict::Approved);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Settings);
  EXPECT_EQ(run.model.entry(1).stale, Staleness::None) << "it is open";
}

TEST_F(InALibrary, StepsOfAClipAreThereAgainWhenItIsOpenedAgain) {
  Run run;
  Session& session = run.session;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { session.open(walk); });
  const Skeleton& skeleton = *session.document().skeleton();
  settleAfter(run, [&] { session.choosePreset(built_in_presets()[2]); });
  EncodeSettings options = session.document().options();
  options.target = {Target::Kind::Ratio, 36.885};
  settleAfter(run, [&] { session.setOptions(options); });
  NamedImportance care;
  care.factors = {{"lhand", 4}};
  options.importance = importance_for(care, skeleton);
  settleAfter(run, [&] { session.setImportance(options.importance); });
  settleAfter(run, [&] { session.setContacts({{4, 10, 20}}); });
  const int steps = session.history()->count();
  EXPECT_EQ(steps, 4);
  settleAfter(run, [&] { session.open(clip("jump.bvh", 2)); });
  EXPECT_EQ(session.history()->count(), 0);
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_EQ(session.history()->count(), steps);
  EXPECT_TRUE(session.history()->canUndo());
}

TEST_F(InALibrary, UndoReportsTheClipsThatItRemoves) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2)});
  QSignalSpy noted(&run.library, &Library::noted);
  run.library.history()->undo();
  ASSERT_EQ(noted.count(), 1);
  EXPECT_TRUE(noted[0][0].toString().contains(QLatin1Char('2')));
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

TEST_F(InALibrary, ABatchsResultIsInTheClipsRow) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  run.library.add({walk, clip("jump.bvh", 2)});
  QTRY_VERIFY_WITH_TIMEOUT(!run.library.project().clips[1].stamp.hash.empty(), kPatience);
  settleAfter(run, [&] { run.library.openClip(1); });
  BatchStep step{.ended = true, .source = run.library.project().clips[0].stamp.source};
  step.measured = Measurement{.ratio = 33, .eps_bone_ends_cm = 0.4};
  step.measured->seen = Seen{.times_noticed = 1.5};
  step.warnings = {"line 3 was repaired"};
  const Settings preset{.name = "own", .weighting = Weighting::BoneEnds};
  run.library.noteExported(walk, preset, {}, step);
  const LibraryEntry& entry = run.model.entry(0);
  ASSERT_TRUE(entry.outcome);
  EXPECT_EQ(entry.outcome->ratio, 33);
  EXPECT_EQ(entry.outcome->eps_cm, 0.4);
  EXPECT_EQ(entry.outcome->sight, Sight::Borderline);
  EXPECT_EQ(entry.outcome->warnings.size(), 1);
  EXPECT_EQ(entry.outdated, Staleness::None);
  // An export with other settings does not change the outcome of a clip with its own.
  const Outcome tuned = *run.model.entry(1).outcome;
  run.library.noteExported(run.model.entry(1).path, preset, {}, step);
  EXPECT_EQ(*run.model.entry(1).outcome, tuned);
}

TEST_F(InALibrary, TheQueueOfABatchGoesWithItsProject) {
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

TEST_F(InALibrary, AProjectIsNotLeftWhileItsLeaveCheckRefuses) {
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

TEST_F(InALibrary, VerdictsAndNotesAreUndoneInItsOwnHistory) {
  Run run;
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  settleAfter(run, [&] { run.session.open(clip("jump.bvh", 2)); });
  run.library.setVerdict({0}, Verdict::Rejected);
  for (const char* typed : {"k", "kn", "knee"}) run.library.setNote(1, QString::fromLatin1(typed));
  run.library.setVerdict({1}, Verdict::Approved);
  EXPECT_FALSE(run.session.history()->canUndo());
  QUndoStack& history = *run.library.history();
  EXPECT_EQ(history.count(), 3) << "a note typed in one go is one step";
  EXPECT_EQ(history.undoText().toStdString(), "Verdict");
  const auto& clips = run.library.project().clips;
  history.undo();
  EXPECT_EQ(clips[1].review.verdict, Verdict::None);
  EXPECT_EQ(clips[1].review.note, "knee");
  EXPECT_EQ(history.undoText().toStdString(), "Note");
  history.undo();
  EXPECT_EQ(clips[1].review.note, "");
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Rejected);
  history.undo();
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::None);
  EXPECT_FALSE(history.canUndo());
  history.redo();
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Rejected);
}

TEST_F(InALibrary, NotesOfTwoClipsAreTwoStepsHoweverQuicklyTheyAreTyped) {
  Run run;
  run.library.add({clip("walk.bvh", 1), clip("jump.bvh", 2)});
  run.library.setNote(0, QStringLiteral("knee"));
  run.library.setNote(1, QStringLiteral("wrist"));
  run.library.history()->undo();
  EXPECT_EQ(run.library.project().clips[0].review.note, "knee");
  EXPECT_EQ(run.library.project().clips[1].review.note, "");
}

TEST_F(InALibrary, ARemovalIsUndoneWhileAnotherClipIsOpenAndItsSettingsStay) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.open(clip("jump.bvh", 2)); });
  run.library.remove({0});
  settleAfter(run, [&] { run.session.setOptions(standard(40)); });
  run.library.history()->undo();
  ASSERT_EQ(run.model.rowCount(), 2);
  EXPECT_EQ(run.library.project().clips[0].path, walk);
  EXPECT_EQ(run.session.document().options().target.value, 40);
  settleAfter(run, [&] { run.session.history()->undo(); });
  EXPECT_EQ(run.session.document().options().target.value, 10);
  EXPECT_EQ(run.model.rowCount(), 2) << "a slider does not touch the library";
}

TEST_F(InALibrary, AClipThatWasRemovedComesBackAsItWas) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standard(20)); });
  run.library.setNote(0, QStringLiteral("knee"));
  settleAfter(run, [&] { run.session.open(clip("jump.bvh", 2)); });
  run.library.remove({0});
  ASSERT_EQ(run.model.rowCount(), 1);
  EXPECT_EQ(run.library.history()->undoText().toStdString(), "Remove Clip");
  run.library.history()->undo();
  ASSERT_EQ(run.model.rowCount(), 2);
  const ProjectClip& back = run.library.project().clips[0];
  EXPECT_EQ(back.path, walk);
  EXPECT_EQ(back.review.note, "knee");
  EXPECT_EQ(back.settings->preset.target.value, 20);
  EXPECT_EQ(run.model.entry(0).path, walk);
}

TEST_F(InALibrary, ClipsThatWereAddedAreTakenOutAgainAndComeBackAsTheyWere) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  const QString jump = clip("jump.bvh", 2);
  settleAfter(run, [&] { run.session.open(walk); });
  run.library.add({walk});
  EXPECT_FALSE(run.library.history()->canUndo()) << "it was there";
  run.library.add({walk, jump});
  ASSERT_EQ(run.model.rowCount(), 2);
  EXPECT_EQ(run.library.history()->undoText().toStdString(), "Add Clips");
  settleAfter(run, [&] { run.session.open(jump); });
  settleAfter(run, [&] { run.session.setOptions(standard(30)); });
  run.library.history()->undo();
  EXPECT_EQ(run.model.rowCount(), 1);
  EXPECT_EQ(run.library.project().clips.size(), 1u);
  run.library.history()->redo();
  ASSERT_EQ(run.model.rowCount(), 2);
  EXPECT_EQ(run.model.entry(1).path, jump);
  EXPECT_EQ(run.library.project().clips[1].settings->preset.target.value, 30);
}

TEST_F(InALibrary, AChangeOfFileLosesNothingOfTheOneBefore) {
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

TEST_F(InALibrary, AnotherProjectHasNothingToUndo) {
  Run run;
  run.library.begin(data());
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  settleAfter(run, [&] { run.session.setOptions(standard(20)); });
  run.library.setVerdict({0}, Verdict::Approved);
  run.library.startNew();
  EXPECT_FALSE(run.session.history()->canUndo());
  EXPECT_FALSE(run.library.history()->canUndo());
}

TEST_F(InALibrary, GivesClipsToABatchWithTheSettingsTheyWereTunedBy) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standard(20)); });
  run.library.add({clip("jump.bvh", 2)});
  const std::vector<TunedClip> all = run.library.tuned({});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].path, walk);
  EXPECT_EQ(all[0].settings->preset.target.value, 20);
  EXPECT_FALSE(all[1].settings);
  ASSERT_EQ(run.library.tuned({1}).size(), 1u);
  EXPECT_EQ(run.library.tuned({1})[0].path, all[1].path);
}

TEST_F(InALibrary, ClipsThatCannotBeReadAreListedWithTheirReason) {
  Run run;
  run.library.add({directory_.filePath(QStringLiteral("missing.bvh")), clip("walk.bvh", 1)});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return run.model.entry(1).frames > 0 && !run.model.entry(0).trouble.isEmpty(); },
      kPatience));
  EXPECT_FALSE(run.model.entry(1).outline.isEmpty());
  for (const QLineF& bone : run.model.entry(1).outline)
    for (const QPointF& end : {bone.p1(), bone.p2()})
      EXPECT_TRUE(QRectF(-1e-6, -1e-6, 1 + 2e-6, 1 + 2e-6).contains(end));
}

TEST_F(InALibrary, AFolderBringsEveryClipBelowIt) {
  Run run;
  QDir(directory_.path()).mkpath(QStringLiteral("moves/walks/slow"));
  const QString deep = clip("moves/walks/slow/a.bvh", 1);
  const QString shallow = clip("moves/b.bvh", 2);
  clip("elsewhere.bvh", 3);
  const QString empty = directory_.filePath(QStringLiteral("empty"));
  QDir().mkpath(empty);
  run.library.add({shallow});
  run.library.addFolder(directory_.filePath(QStringLiteral("moves")));
  QSignalSpy failed(&run.library, &Library::failed);
  run.library.addFolder(empty);
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() > 0; }, kPatience));
  ASSERT_EQ(run.model.rowCount(), 2) << "each once";
  EXPECT_GE(run.model.rowOf(deep), 0);
  run.library.remove({0});
  EXPECT_EQ(run.model.rowOf(deep), 0);
  EXPECT_EQ(run.library.project().clips.size(), 1u);
}

TEST_F(InALibrary, SlotsAreSwitchedCopiedAndUndone) {
  Run run;
  Session& session = run.session;
  settleAfter(run, [&] { session.open(clip("walk.bvh", 1)); });
  const auto target = [&] { return session.document().options().target.value; };
  settleAfter(run, [&] { session.switchSlot(); });
  settleAfter(run, [&] { session.setOptions(standard(40)); });
  EXPECT_EQ(session.document().tuning().active, 1);
  settleAfter(run, [&] { session.switchSlot(); });
  EXPECT_DOUBLE_EQ(target(), 10);
  const auto ratio_of = [&](int slot) {
    const auto figures = session.slotFigures(slot);
    return figures ? figures->ratio : 0;
  };
  EXPECT_NEAR(ratio_of(0), 10, 1);
  EXPECT_NEAR(ratio_of(1), 40, 1);
  settleAfter(run, [&] { session.open(clip("jump.bvh", 2)); });
  settleAfter(run, [&] { session.open(clip("walk.bvh", 1)); });
  EXPECT_NEAR(ratio_of(1), 40, 1) << "also of a clip that one comes back to";
  settleAfter(run, [&] { session.copyToOtherSlot(); });
  EXPECT_NEAR(ratio_of(1), 10, 1) << "what is the same came to the same";
  const int steps = session.history()->count();
  session.copyToOtherSlot();
  EXPECT_EQ(session.history()->count(), steps) << "they are the same";
  settleAfter(run, [&] { session.switchSlot(); });
  EXPECT_DOUBLE_EQ(target(), 10);
  settleAfter(run, [&] { session.history()->undo(); });  // undoes the switch
  settleAfter(run, [&] { session.history()->undo(); });  // undoes the copy
  EXPECT_NEAR(ratio_of(1), 40, 1);
  settleAfter(run, [&] { session.switchSlot(); });
  EXPECT_DOUBLE_EQ(target(), 40);
}

TEST_F(InALibrary, SettingsThatDoNotFitTheClipAreLeftOut) {
  const QString walk = clip("walk.bvh", 1);
  const Skeleton skeleton = test::small_skeleton();
  NamedSettings settings = namedSettings({standard(15), {}, {}}, skeleton);
  const std::string point = landmarks(skeleton)[4].name;
  settings.preset.contacts = {{"tail_3", 0, 3}, {point, 10, 5000}, {point, 10, 20}};
  Project project;
  project.current = walk;
  project.clips = {{.path = walk, .settings = settings}};
  const QString file = path("project.mocapress");
  writeProject(file, project);
  Run run;
  settleAfter(run, [&] { run.library.open(file); });
  EXPECT_EQ(run.session.document().contacts(), (std::vector<ContactSpan>{{4, 10, 20}}));
}

TEST_F(InALibrary, AnOpenedClipKeepsTheSettingsOfItsOutcome) {
  Run run;
  run.library.add({clip("walk.bvh", 1), clip("jump.bvh", 2)});
  settleAfter(run, [&] { run.library.openClip(0); });
  const std::vector<TunedClip> tuned = run.library.tuned({0});
  ASSERT_TRUE(tuned[0].settings);
  EXPECT_EQ(tuned[0].settings->preset.target.value, 10);
  settleAfter(run, [&] { run.library.openClip(1); });
  settleAfter(run, [&] { run.session.setOptions(standard(40)); });
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_EQ(run.session.document().options().target.value, 10);
}

TEST_F(InALibrary, SeveralClipsGoAndComeBackInOneChangeOfTheList) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2), clip("c.bvh", 3), clip("d.bvh", 4)});
  QSignalSpy reset(&run.model, &LibraryModel::modelReset);
  run.library.remove({3, 0, 2});
  EXPECT_EQ(reset.count(), 1);
  ASSERT_EQ(run.model.rowCount(), 1);
  EXPECT_TRUE(run.library.project().clips[0].path.endsWith(QStringLiteral("b.bvh")));
  run.library.history()->undo();
  EXPECT_EQ(reset.count(), 2);
  ASSERT_EQ(run.model.rowCount(), 4);
  for (int row = 0; row < 4; ++row) {
    const QString name = QString(QLatin1Char(static_cast<char>('a' + row)));
    EXPECT_TRUE(run.model.entry(row).path.endsWith(name + QStringLiteral(".bvh"))) << row;
    EXPECT_EQ(run.library.project().clips[static_cast<std::size_t>(row)].path,
              run.model.entry(row).path);
  }
}

/// A file of two takes, "Idle" and "Run".
QString writeTwoTakes(const QString& path) {
  const Motion idle = test::smooth_motion(60, 1), run = test::smooth_motion(90, 2);
  write_takes(path.toStdU16String(), {{"Idle", idle, {}}, {"Run", run, {}}});
  return path;
}

TEST_F(InALibrary, ListsEachTakeOfAFileWithSettingsOfItsOwn) {
  Run run;
  const QString file = writeTwoTakes(path("moves.fbx"));
  clip("walk.bvh", 3);
  run.library.add({file, path("walk.bvh")});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return run.model.rowCount() == 3 && run.model.entry(1).frames > 0; }, kPatience));
  EXPECT_EQ(run.model.entry(0).name(), QStringLiteral("moves.fbx: Idle"));
  EXPECT_EQ(run.model.entry(1).name(), QStringLiteral("moves.fbx: Run"));
  EXPECT_EQ(run.model.entry(1).frames, 90);
  EXPECT_EQ(run.model.entry(2).name(), QStringLiteral("walk.bvh"));

  settleAfter(run, [&] { run.library.openClip(0); });
  settleAfter(run,
              [&] { run.session.setRanges({{.first_frame = 5, .last_frame = 9, .factor = 3}}); });
  run.library.setVerdict({0}, Verdict::Approved);
  settleAfter(run, [&] { run.session.chooseTake(1); });
  EXPECT_EQ(run.library.currentRow(), 1);
  EXPECT_TRUE(run.session.document().options().ranges.empty());
  EXPECT_EQ(run.model.entry(1).review.verdict, Verdict::None);
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_EQ(run.session.document().options().ranges.size(), 1u);
  EXPECT_EQ(run.session.document().frames(), 60);
}

TEST_F(InALibrary, KeepsTheTakesThatWereNotTakenOut) {
  const QString file = writeTwoTakes(path("moves.fbx"));
  {
    Run run;
    run.library.begin(data());
    settleAfter(run, [&] { run.session.open(file); });
    ASSERT_EQ(run.model.rowCount(), 2);
    EXPECT_EQ(run.library.currentRow(), 0);
    run.library.remove({1});
    run.library.end();
  }
  Run run;
  settleAfter(run, [&] { run.library.begin(data()); });
  EXPECT_EQ(run.library.currentRow(), 0);
  EXPECT_EQ(run.model.rowCount(), 1);
  EXPECT_EQ(run.session.document().frames(), 60);
}

}  // namespace
}  // namespace mocapress
