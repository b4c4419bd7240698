// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/library.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include "app/jobs/batch_runner.h"
#include "core/base/file.h"
#include "core/batch/batch_folder.h"
#include "core/batch/project_batch.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/motion/landmarks.h"
#include "tests/qt/library_on_disk.h"

namespace mocapress {
namespace {

TEST_F(InALibrary, EveryClipHasItsOwnSettings) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  const QString jump = clip("jump.bvh", 2);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(20)); });
  settleAfter(run, [&] { run.session.open(jump); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(40)); });
  settleAfter(run, [&] { run.library.openClip(0); });
  EXPECT_DOUBLE_EQ(run.session.document().options().target.value, 20);
  settleAfter(run, [&] { run.library.openClip(1); });
  EXPECT_DOUBLE_EQ(run.session.document().options().target.value, 40);
  EXPECT_NEAR(run.model.entry(0).outcome->ratio, 20, 0.5);
  EXPECT_TRUE(run.model.entry(1).outcome->met);
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

/// As the background and a batch compress it, whichever clip was tuned before.
TEST_F(InALibrary, AClipWithoutSettingsIsOpenedWithTheUsualOnes) {
  Run run;
  run.library.add({clip("a.bvh", 1), clip("b.bvh", 2)});
  settleAfter(run, [&] { run.library.openClip(0); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(40)); });
  settleAfter(run, [&] { run.library.openClip(1); });
  EXPECT_EQ(run.library.project().clips[1].settings->preset, usualPreset());
  settleAfter(run, [&] { run.session.open(clip("c.bvh", 3)); });
  EXPECT_EQ(run.library.project().clips[2].settings->preset, usualPreset());
}

TEST_F(InALibrary, ABatchOfItsProjectWritesTheBytesThatTheStudioSaves) {
  Run run;
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  EncodeSettings options = withPreset(run.session.document().settings(), usualPreset(),
                                      *run.session.document().skeleton())
                               .encode;
  const auto batch_equals_studio = [&](const EncodeSettings& tuned, const char* name) {
    settleAfter(run, [&] { run.session.setOptions(tuned); });
    const QString saved = path(name) + QStringLiteral(".mcpr");
    QSignalSpy written(&run.session, &Session::saved);
    run.session.save(saved);
    ASSERT_TRUE(written.count() > 0 || written.wait(kPatience));
    Batch batch{.presets = {usualPreset()}};
    const QDir folder(QFileInfo(saved).absolutePath());
    add_project(batch, path("hero.mocapress").toStdString(),
                projectText(run.library.project(), folder).toStdString(), "{stem}");
    const auto out = path(name).toStdU16String();
    BatchControl control;
    run_batch_in(out, batch, {}, control);
    EXPECT_EQ(read_bytes(saved.toStdU16String()),
              read_bytes(std::filesystem::path(out) / "walk.mcpr"))
        << name;
  };
  batch_equals_studio(options, "usual");
  options.target.value = 0.5;
  ASSERT_TRUE(options.promises.any()) << "kept though the target was moved";
  batch_equals_studio(options, "moved");
  options.ranges = {{20, 60, 3}};
  options.contacts = std::vector<ContactSpan>{{4, 10, 20}};
  options.ends = Ends::Exact;
  batch_equals_studio(options, "elaborate");
  options.target = {Target::Kind::Ratio, 20};
  options.correction = EncodeCorrection{.joints = {4}};
  batch_equals_studio(options, "held");
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
    settleAfter(run, [&] { run.session.setOptions(standardAt(17)); });
    settleAfter(run, [&] { run.session.choosePreset(preset); });
    EXPECT_EQ(run.library.project().clips[1].settings->preset, preset);
  }
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

TEST_F(InALibrary, ARemovalIsUndoneWhileAnotherClipIsOpenAndItsSettingsStay) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.open(clip("jump.bvh", 2)); });
  run.library.remove({0});
  settleAfter(run, [&] { run.session.setOptions(standardAt(40)); });
  run.library.history()->undo();
  ASSERT_EQ(run.model.rowCount(), 2);
  EXPECT_EQ(run.library.project().clips[0].path, walk);
  EXPECT_EQ(run.session.document().options().target.value, 40);
  settleAfter(run, [&] { run.session.history()->undo(); });
  EXPECT_EQ(run.session.document().options().target, usualPreset().target);
  EXPECT_EQ(run.model.rowCount(), 2) << "a slider does not touch the library";
}

TEST_F(InALibrary, AClipThatWasRemovedComesBackAsItWas) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(20)); });
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
  settleAfter(run, [&] { run.session.setOptions(standardAt(30)); });
  run.library.history()->undo();
  EXPECT_EQ(run.model.rowCount(), 1);
  EXPECT_EQ(run.library.project().clips.size(), 1u);
  run.library.history()->redo();
  ASSERT_EQ(run.model.rowCount(), 2);
  EXPECT_EQ(run.model.entry(1).path, jump);
  EXPECT_EQ(run.library.project().clips[1].settings->preset.target.value, 30);
}

TEST_F(InALibrary, AnotherProjectHasNothingToUndo) {
  Run run;
  run.library.begin(data());
  settleAfter(run, [&] { run.session.open(clip("walk.bvh", 1)); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(20)); });
  run.library.setVerdict({0}, Verdict::Approved);
  run.library.startNew();
  EXPECT_FALSE(run.session.history()->canUndo());
  EXPECT_FALSE(run.library.history()->canUndo());
}

TEST_F(InALibrary, GivesClipsToABatchWithTheSettingsTheyWereTunedBy) {
  Run run;
  const QString walk = clip("walk.bvh", 1);
  settleAfter(run, [&] { run.session.open(walk); });
  settleAfter(run, [&] { run.session.setOptions(standardAt(20)); });
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
  settleAfter(run, [&] { session.setOptions(standardAt(40)); });
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
  NamedSettings settings = namedSettings({standardAt(15), {}, {}}, skeleton);
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
  settleAfter(run, [&] { run.session.setOptions(standardAt(40)); });
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
