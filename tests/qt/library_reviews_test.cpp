// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts and notes on clips.
#include <gtest/gtest.h>

#include <QDateTime>
#include <QFile>
#include <QTest>

#include "tests/qt/library_on_disk.h"

namespace mocapress {
namespace {

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
  settleAfter(run, [&] { run.session.setOptions(standardAt(50)); });
  EXPECT_EQ(run.model.entry(0).review.verdict, Verdict::Approved);
  EXPECT_EQ(run.model.entry(0).stale, Staleness::Settings);
  settleAfter(run, [&] { run.session.history()->undo(); });
  EXPECT_EQ(run.model.entry(0).stale, Staleness::None);
}

TEST_F(InALibrary, RemarksAreTheVerdictWithWhatMakesItStaleAndTheNote) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  EXPECT_TRUE(run.library.remarksOn(walk).texts.empty());
  run.library.setNote(0, QStringLiteral("look at the wrist"));
  run.library.setVerdict({0}, Verdict::Approved);
  const std::vector<std::string> remarks = run.library.remarksOn(walk).texts;
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_TRUE(remarks[0].starts_with("approved by ")) << remarks[0];
  EXPECT_EQ(remarks[0].find("stale"), std::string::npos);
  EXPECT_EQ(remarks[1], "look at the wrist");
  settleAfter(run, [&] { run.session.setOptions(standardAt(50)); });
  EXPECT_TRUE(run.library.remarksOn(walk).texts[0].ends_with("stale: the settings changed"));
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

}  // namespace
}  // namespace mocapress
