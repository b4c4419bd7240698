// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_session.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/studio/batch/batch_memory.h"
#include "app/studio/batch/batch_window.h"
#include "app/studio/document/preset_shelf.h"
#include "core/bank/bank_file.h"
#include "core/base/file.h"
#include "core/batch/queue_json.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/qt/well_formed.h"
#include "tests/support/svg_frame.h"
#include "tests/support/test_motion.h"
#include "widgets/panels/batch_output.h"

namespace mocapress {
namespace {

using BatchState = BatchSession::State;
using ClipState = QueuedClip::State;

class BatchInTheStudio : public testing::Test {
 protected:
  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }

  void addClips(int count, int frames = 120) {
    QStringList paths;
    for (int i = 0; i < count; ++i) {
      const QString clip = path(("clip" + std::to_string(i) + ".bvh").c_str());
      write_motion(clip.toStdU16String(), test::smooth_motion(frames, static_cast<unsigned>(i)));
      paths << clip;
    }
    session_.addClips(paths);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == count; }, kPatience));
    session_.setSettings({.folder = path("out")});
    const Settings rough{.name = "rough", .target = {Target::Kind::Error, 2}};
    session_.setCommon(rough);
  }

  void chooseBank(runtime::BankForm form, bool learn = false) {
    BatchSettings settings = session_.settings();
    settings.bank = form;
    settings.learn = learn;
    session_.setSettings(settings);
  }

  bool waitForEnd() {
    return QTest::qWaitFor([this] { return !session_.running(); }, kPatience);
  }

  int count(ClipState state) const { return session_.queue()->count(state); }

  QTemporaryDir directory_;
  PresetShelf presets_{directory_.filePath(QStringLiteral("presets.json"))};
  BatchSession session_{&presets_};
};

TEST_F(BatchInTheStudio, ExportsTheQueueAndShowsTheResultOfEachClip) {
  addClips(3);
  session_.start();
  EXPECT_TRUE(session_.running());
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete);
  EXPECT_EQ(count(ClipState::Done), 3);
  for (const QueuedClip& clip : session_.queue()->clips()) {
    ASSERT_TRUE(clip.measured);
    EXPECT_LE(clip.measured->eps_bone_ends_cm, 2);
  }
  EXPECT_TRUE(QFileInfo::exists(path("out/clip0.mcpr")));
  EXPECT_TRUE(QFileInfo::exists(session_.report()));
  EXPECT_EQ(session_.fraction(), 1);
}

TEST_F(BatchInTheStudio, SaysWhereItsReportIsToThoseWithoutABrowser) {
  addClips(1);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  BatchWindow window(&session_, nullptr);
  window.reportButton()->click();
  const QList<QLabel*> labels = window.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->text().contains(QDir::toNativeSeparators(session_.report()));
  }));
}

TEST_F(BatchInTheStudio, SaysWhatIsMissingBeforeItCanStart) {
  EXPECT_FALSE(session_.obstacle().isEmpty());
  session_.start();
  EXPECT_FALSE(session_.running());
  addClips(1);
  EXPECT_TRUE(session_.obstacle().isEmpty());
  BatchSettings settings = session_.settings();
  settings.names = QStringLiteral("{nothing}");
  session_.setSettings(settings);
  EXPECT_TRUE(session_.obstacle().contains(QStringLiteral("{nothing}")));
  settings.names = QStringLiteral("{stem}");
  settings.formats.clear();
  session_.setSettings(settings);
  EXPECT_FALSE(session_.obstacle().isEmpty());
}

TEST_F(BatchInTheStudio, ALockedClipIsExportedByItsOwnSettings) {
  addClips(2);
  session_.queue()->setOwn({1}, Settings{.name = "fine", .target = {Target::Kind::Error, 0.2}});
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_GT(session_.queue()->clips()[0].measured->eps_bone_ends_cm, 0.2);
  EXPECT_LE(session_.queue()->clips()[1].measured->eps_bone_ends_cm, 0.2);
}

TEST_F(BatchInTheStudio, RetriesFailedClipsAndKeepsFinishedOnes) {
  addClips(3);
  const std::string good = read_text(path("clip1.bvh").toStdString());
  write_text(path("clip1.bvh").toStdString(), "nonsense");
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete);
  EXPECT_EQ(session_.counts().failed, 1u);
  EXPECT_EQ(session_.queue()->clips()[1].state, ClipState::Failed);
  EXPECT_TRUE(startText(session_).contains(QLatin1Char('1')));
  write_text(path("clip1.bvh").toStdString(), good);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.counts().failed, 0u);
  EXPECT_EQ(session_.counts().kept, 2u);
  EXPECT_EQ(count(ClipState::Done), 3);
}

TEST_F(BatchInTheStudio, MakesNoProgressWhilePaused) {
  addClips(4, 900);
  session_.start();
  session_.pause();
  EXPECT_EQ(session_.state(), BatchState::Paused);
  // This session would have finished before a second one that does the same.
  BatchSession other(&presets_);
  other.queue()->setCommon(session_.queue()->common());
  other.queue()->add(session_.queue()->clips());
  other.setSettings({.folder = path("other")});
  other.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !other.running(); }, kPatience));
  EXPECT_EQ(other.counts().done, 4u);
  EXPECT_LT(session_.counts().done, 4u);
  EXPECT_EQ(session_.state(), BatchState::Paused);
  session_.goOn();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 4);
}

TEST_F(BatchInTheStudio, CancelLeavesClipsWaitingForTheNextRun) {
  addClips(6, 900);
  session_.start();
  ASSERT_TRUE(QTest::qWaitFor([this] { return session_.counts().done > 0; }, kPatience));
  session_.cancel();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Working), 0);
  EXPECT_EQ(count(ClipState::Failed), 0);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete);
  EXPECT_EQ(count(ClipState::Done), 6);
}

TEST_F(BatchInTheStudio, StoppedAfterCurrentNothingIsLeftHalfDone) {
  addClips(8, 900);
  session_.start();
  session_.stopAfterCurrent();
  EXPECT_EQ(session_.state(), BatchState::Stopping);
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Working), 0);
  EXPECT_LT(count(ClipState::Done), 8);
}

TEST_F(BatchInTheStudio, CanBeDestroyedWhilePaused) {
  addClips(2, 900);
  auto other = std::make_unique<BatchSession>(&presets_);
  other->queue()->add(session_.queue()->clips());
  other->setSettings({.folder = path("other")});
  other->start();
  other->pause();
  const RememberedBatch remembered = other->remembered();
  other.reset();
  BatchSession later(&presets_);
  later.recall(remembered);
  later.start();  // the lock on the batch's folder was released
  ASSERT_TRUE(QTest::qWaitFor([&] { return !later.running(); }, kPatience));
  EXPECT_EQ(later.state(), BatchState::Complete);
  EXPECT_EQ(later.queue()->count(ClipState::Done), 2);
}

TEST_F(BatchInTheStudio, TheQueueIsKeptWithItsProjectWhereverThatIsMoved) {
  addClips(3);
  session_.queue()->setOwn({2}, built_in_presets()[3]);
  BatchSettings settings = session_.settings();
  settings.bank = runtime::BankForm::Cooked;
  settings.learn = true;
  settings.character = path("hero.glb");
  session_.setSettings(settings);
  const QDir folder(directory_.path());
  const Json kept = toJson(session_.remembered(), folder);
  EXPECT_EQ(kept.dump().find(directory_.path().toStdString()), std::string::npos);
  BatchSession later(&presets_);
  later.recall(batchFrom(kept, folder));
  ASSERT_EQ(later.queue()->rowCount(), 3);
  EXPECT_EQ(later.queue()->clips()[1].source, session_.queue()->clips()[1].source);
  EXPECT_EQ(later.queue()->clips()[2].own, built_in_presets()[3]);
  EXPECT_EQ(later.queue()->common(), session_.queue()->common());
  EXPECT_EQ(later.settings(), session_.settings());
  EXPECT_EQ(later.queue()->count(ClipState::Waiting), 3);
  later.recall(batchFrom(kept, QDir(QStringLiteral("/elsewhere"))));
  EXPECT_EQ(later.settings().character, QStringLiteral("/elsewhere/hero.glb"));
  EXPECT_EQ(later.queue()->clips()[0].source.path, "/elsewhere/clip0.bvh");
}

TEST_F(BatchInTheStudio, ChangesAreKeptSoon) {
  QSignalSpy keep(&session_, &BatchSession::keep);
  addClips(1);
  ASSERT_TRUE(keep.count() > 0 || keep.wait(kPatience));
  session_.rememberNow();
  EXPECT_EQ(keep.count(), 1) << "nothing waits";
  session_.queue()->setLeftOut({0}, true);
  session_.rememberNow();
  EXPECT_EQ(keep.count(), 2);
}

TEST_F(BatchInTheStudio, LoadingAnotherProjectsQueueReplacesAllOfTheOldOne) {
  addClips(2);
  session_.recall({});
  EXPECT_EQ(session_.queue()->rowCount(), 0);
  EXPECT_TRUE(session_.settings().folder.isEmpty());
  EXPECT_FALSE(session_.history().canUndo());
}

TEST_F(BatchInTheStudio, MarksVerdictsOnOtherFilesOrSettingsThanThoseExported) {
  addClips(3);
  const std::string key = settings_hash(session_.queue()->common(), {});
  const auto approved = [](const std::string& source, const std::string& settings) {
    return ClipReview{Verdict::Approved, "", "ann", "2026-11-27T01:39:46Z", source, settings};
  };
  session_.setReviews({{path("clip0.bvh"), {approved("1", key), "1"}},
                       {path("clip1.bvh"), {approved("1", key), "2"}},
                       {path("clip2.bvh"), {approved("1", key), "1", true}}});
  const auto said = [this](int row) {
    return session_.queue()->index(row, BatchQueueModel::Review).data().toString();
  };
  EXPECT_EQ(said(0), QStringLiteral("✓ approved"));
  EXPECT_EQ(said(1), QStringLiteral("✓ stale: file changed"));
  EXPECT_EQ(said(2), QStringLiteral("✓ stale: file missing"));
  EXPECT_EQ(session_.queue()->countStale(), 2);
  Settings coarser = session_.queue()->common();
  coarser.target.value *= 2;
  session_.setCommon(coarser);
  EXPECT_EQ(said(0), QStringLiteral("✓ stale: settings changed"));
  EXPECT_TRUE(statusOf(session_).contains(QStringLiteral("3 with a stale verdict")));
}

TEST_F(BatchInTheStudio, ReportsTheResultOfEachClip) {
  addClips(2);
  QSignalSpy exported(&session_, &BatchSession::exported);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(exported.count(), 2);
}

TEST_F(BatchInTheStudio, AFolderThatSlurmCannotNameIsRefusedAndNothingIsWritten) {
  addClips(1);
  session_.setSettings({.folder = path("two\nlines")});
  QSignalSpy noted(&session_, &BatchSession::noted);
  session_.writeSlurm(path("job.sh"), 5);
  ASSERT_EQ(noted.count(), 1);
  EXPECT_TRUE(noted[0][0].toString().contains(QStringLiteral("line break")));
  EXPECT_FALSE(QFileInfo::exists(path("job.sh")));
  EXPECT_FALSE(QFileInfo::exists(path("two\nlines")));
}

TEST_F(BatchInTheStudio, ExportsClipsByTheSettingsTheyWereTunedBy) {
  addClips(2);
  const Skeleton skeleton = test::smooth_motion(120).skeleton;
  ClipSettings tuned;
  tuned.encode = {.method = Method::ClosedLoop, .target = {Target::Kind::Error, 0.2}};
  tuned.encode.importance.joints.assign(static_cast<std::size_t>(skeleton.joint_count()), 1.0);
  tuned.encode.importance.joints[static_cast<std::size_t>(skeleton.find("lhand"))] = 4;
  tuned.encode.contacts = std::vector<ContactSpan>{{4, 10, 20}};
  const QString other = path("other.bvh");
  write_motion(other.toStdU16String(), test::smooth_motion(100, 9));
  session_.addTuned(
      {{path("clip1.bvh"), {}, namedSettings(tuned, skeleton)}, {other, {}, std::nullopt}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == 3; }, kPatience));
  const std::vector<QueuedClip>& clips = session_.queue()->clips();
  EXPECT_FALSE(clips[0].own);
  ASSERT_TRUE(clips[1].own) << "there already, and locked now";
  EXPECT_EQ(clips[1].own->importance.factor("lhand"), 4);
  EXPECT_EQ(clips[1].own->contacts->front().first_frame, 10);
  EXPECT_FALSE(clips[2].own);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 3);
  EXPECT_LE(session_.queue()->clips()[1].measured->eps_bone_ends_cm, 0.2);
}

TEST_F(BatchInTheStudio, ClipsOfTheLibraryAreReadByTheirImportOptions) {
  addClips(1);
  session_.addTuned({{.path = path("clip0.bvh"), .reading = {.sample_rate_hz = 25}}});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return session_.queue()->clips()[0].reading.sample_rate_hz == 25; }, kPatience));
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.queue()->clips()[0].measured->sample_rate_hz, 25);
}

TEST_F(BatchInTheStudio, ContactsBeyondAClipAreItsFailure) {
  addClips(1);
  session_.queue()->setOwn(
      {0}, Settings{.name = "own", .contacts = std::vector<ContactSetting>{{"lhand", 100, 400}}});
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.queue()->clips()[0].state, ClipState::Failed);
  EXPECT_NE(session_.queue()->clips()[0].error.find("frame 401"), std::string::npos);
}

TEST_F(BatchInTheStudio, ARejectedClipIsNotExportedUnlessAskedFor) {
  addClips(3);
  const auto said = [this](const char* clip, Verdict verdict, const char* note) {
    const std::string source = hash_of(path(clip).toStdU16String());
    const std::string settings = settings_hash(session_.queue()->common(), {});
    return LibraryReview{{verdict, note, "ann", "2026-11-27T01:39:46Z", source, settings}, source};
  };
  session_.setReviews({{path("clip1.bvh"), said("clip1.bvh", Verdict::Rejected, "slides")},
                       {path("clip2.bvh"), said("clip2.bvh", Verdict::Approved, "good")}});
  EXPECT_TRUE(statusOf(session_).contains(QLatin1Char('2'))) << qPrintable(statusOf(session_));
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete);
  EXPECT_FALSE(QFileInfo::exists(path("out/clip1.mcpr")));
  EXPECT_EQ(session_.queue()->clips()[1].state, ClipState::Waiting);
  EXPECT_EQ(session_.queue()->clips()[2].state, ClipState::Done);
  const std::string csv = read_text(path("out/report.csv").toStdString());
  EXPECT_EQ(csv.find("clip1"), std::string::npos);
  EXPECT_NE(csv.find("good"), std::string::npos);

  session_.setLeftOut({1}, false);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_TRUE(QFileInfo::exists(path("out/clip1.mcpr")));
  EXPECT_EQ(session_.counts().kept, 2u);
  EXPECT_NE(read_text(path("out/report.csv").toStdString()).find("slides"), std::string::npos);
}

TEST_F(BatchInTheStudio, LeavesOutAClipThatWasRejectedBeforeItWasAdded) {
  session_.setReviews({{path("clip0.bvh"), {Verdict::Rejected, ""}}});
  addClips(1);
  EXPECT_TRUE(session_.queue()->clips()[0].left_out);
  EXPECT_FALSE(session_.obstacle().isEmpty());
  session_.start();
  EXPECT_FALSE(session_.running());
  session_.setLeftOut({0}, false);
  EXPECT_TRUE(session_.obstacle().isEmpty());
  session_.undo();
  EXPECT_TRUE(session_.queue()->clips()[0].left_out);
}

TEST_F(BatchInTheStudio, VerdictsNotesAndWhatIsLeftOutAreKeptToo) {
  addClips(2);
  session_.setReviews({{path("clip0.bvh"), {Verdict::Rejected, "slides"}}});
  session_.setLeftOut({1}, true);
  session_.setLeftOut({0}, false);
  const QDir folder(directory_.path());
  BatchSession later(&presets_);
  later.recall(batchFrom(toJson(session_.remembered(), folder), folder));
  ASSERT_EQ(later.queue()->rowCount(), 2);
  EXPECT_EQ(later.queue()->clips()[0].review, (ClipReview{Verdict::Rejected, "slides"}));
  EXPECT_FALSE(later.queue()->clips()[0].left_out);
  EXPECT_TRUE(later.queue()->clips()[1].left_out);
}

TEST_F(BatchInTheStudio, ATruncatedFileIsVerifiedWithItsWarning) {
  addClips(1);
  const std::string whole = read_text(path("clip0.bvh").toStdString());
  write_text(path("clip0.bvh").toStdString(), whole.substr(0, whole.rfind('\n', whole.size() - 2)));
  session_.start();
  ASSERT_TRUE(waitForEnd());
  ASSERT_EQ(count(ClipState::Done), 1);
  EXPECT_EQ(session_.queue()->clips()[0].warnings.size(), 1u);
  EXPECT_TRUE(statusOf(session_).contains(QStringLiteral("with warnings")));
}

TEST_F(BatchInTheStudio, ItsReportIsWellFormedAndItsPicturesFillTheirFrames) {
  addClips(2);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  const std::string page = read_text(session_.report().toStdString());
  EXPECT_EQ(test::ill_formed(QString::fromStdString(page)), "");
  EXPECT_EQ(test::misfit(page), "");
}

TEST_F(BatchInTheStudio, WritesItsQueueAndAScriptForSlurm) {
  addClips(3);
  session_.queue()->setOwn({1}, built_in_presets()[3]);
  session_.writeSlurm(path("job.sh"), 5);
  const std::string script = read_text(path("job.sh").toStdString());
  EXPECT_NE(script.find("--array=1-5"), std::string::npos);
  const Batch queue = parse_queue("", read_text(path("out/queue.json").toStdString()));
  ASSERT_EQ(queue.items.size(), 3u);
  EXPECT_EQ(queue.presets[queue.items[1].preset], built_in_presets()[3]);
  EXPECT_EQ(queue.presets[queue.items[2].preset], session_.queue()->common());
}

TEST_F(BatchInTheStudio, MakesABankOfItsCompressedFilesAndOfNothingElse) {
  addClips(2);
  chooseBank(runtime::BankForm::Packed);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(BankFile(path("out/bank.mcpk").toStdString()).clips(), 2u);
  BatchSettings settings = session_.settings();
  settings.formats = {OutputFormat::Bvh};
  session_.setSettings(settings);
  EXPECT_FALSE(session_.obstacle().isEmpty());
}

TEST_F(BatchInTheStudio, SaysThatItLearnsFromTheClipsOfABank) {
  addClips(2);
  chooseBank(runtime::BankForm::Packed, true);
  QStringList said;
  QObject::connect(&session_, &BatchSession::progressed, &session_,
                   [&] { said << statusOf(session_); });
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete);
  EXPECT_FALSE(said.filter(QStringLiteral("Fitting the coder")).isEmpty());
  EXPECT_EQ(BankFile(path("out/bank.mcpk").toStdString()).clips(), 2u);
}

TEST_F(BatchInTheStudio, ACookedBankLearnsNothingThoughThatIsChosen) {
  addClips(1);
  chooseBank(runtime::BankForm::Cooked, true);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), BatchState::Complete) << qPrintable(session_.failure());
  EXPECT_TRUE(BankFile(path("out/bank.mcpk").toStdString()).is_cooked());
}

TEST(BatchOutputTest, OffersToLearnForAPackedBankAndRemembersTheChoice) {
  BatchOutput output;
  BatchSettings chosen;
  QObject::connect(&output, &BatchOutput::settingsChanged, &output,
                   [&](const BatchSettings& settings) { chosen = settings; });
  const auto choose_bank = [&](runtime::BankForm form) {
    output.bank()->setCurrentIndex(output.bank()->findData(static_cast<int>(form)));
    emit output.bank()->activated(output.bank()->currentIndex());
  };
  EXPECT_FALSE(output.learn()->isEnabled());
  choose_bank(runtime::BankForm::Packed);
  EXPECT_TRUE(output.learn()->isEnabled());
  output.learn()->click();
  EXPECT_TRUE(chosen.learn && chosen.learns());
  choose_bank(runtime::BankForm::Cooked);
  EXPECT_FALSE(output.learn()->isEnabled());
  EXPECT_TRUE(chosen.learn && !chosen.learns());
  output.setSettings({.bank = runtime::BankForm::Packed, .learn = true});
  EXPECT_TRUE(output.learn()->isEnabled() && output.learn()->isChecked());
}

TEST_F(BatchInTheStudio, PutsItsCharacterOnEveryClip) {
  const QString samples = QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/");
  if (!QFile::exists(samples + QStringLiteral("character.glb"))) GTEST_SKIP() << "no character";
  const QString walk = samples + QStringLiteral("human_walk.amc");
  session_.addClips({walk});
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == 1; }, kPatience));
  session_.addTuned(
      {{samples + QStringLiteral("human_run.amc"), {}, {}, {.sample_rate_hz = 60.0}}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == 2; }, kPatience));
  session_.setSettings({.folder = path("out")});
  session_.setCommon(
      {.name = "rough", .weighting = Weighting::Skin, .target = {Target::Kind::Error, 2}});
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.counts().failed, 2u) << "there is no skin";

  BatchSettings dressed = session_.settings();
  dressed.character = samples + QStringLiteral("character.glb");
  session_.setSettings(dressed);
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 2);

  // The finished clips no longer match the settings.
  session_.undo();
  EXPECT_TRUE(session_.settings().character.isEmpty());
  EXPECT_EQ(count(ClipState::Waiting), 2);
  session_.redo();
  EXPECT_EQ(session_.settings().character, dressed.character);
}

TEST_F(BatchInTheStudio, KeepsTheCharacterThatEachClipWasTunedOn) {
  const std::string samples = MOCAPRESS_SOURCE_DIR "/resources/samples/";
  if (!QFile::exists(QString::fromStdString(samples + "character.glb"))) GTEST_SKIP();
  const auto tuned = [&](const char* clip, const std::optional<std::string>& character) {
    return TunedClip{QString::fromStdString(samples + clip), {}, {}, {.character = character}};
  };
  const auto reading = [&](int row) {
    return session_.queue()->clips()[static_cast<std::size_t>(row)].reading;
  };
  const std::string human = samples + "character.glb";
  session_.addTuned({tuned("human_walk.amc", human), tuned("human_run.amc", {})});
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == 2; }, kPatience));
  EXPECT_TRUE(session_.settings().character.isEmpty());
  EXPECT_EQ(reading(0).character, human);
  EXPECT_FALSE(reading(1).character);

  const QDir folder(QString::fromStdString(samples));
  const RememberedBatch moved =
      batchFrom(toJson(session_.remembered(), folder), QDir(QStringLiteral("/elsewhere")));
  EXPECT_EQ(moved.clips[0].reading.character, "/elsewhere/character.glb");

  session_.setSettings({.folder = path("out")});
  session_.setCommon(
      {.name = "rough", .weighting = Weighting::Skin, .target = {Target::Kind::Error, 2}});
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 1);
  EXPECT_EQ(count(ClipState::Failed), 1);
}

/// The queue holds clips of several rigs.
TEST_F(BatchInTheStudio, LeavesACharacterOffClipsThatItDoesNotFitAndSaysSo) {
  const QString samples = QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/");
  if (!QFile::exists(samples + QStringLiteral("character.glb"))) GTEST_SKIP() << "no character";
  addClips(1);
  session_.setSettings(
      {.character = samples + QStringLiteral("character.glb"), .folder = path("out")});
  QStringList warnings;
  QObject::connect(&session_, &BatchSession::exported, &session_, [&](int, const BatchStep& step) {
    for (const std::string& warning : step.warnings) warnings << QString::fromStdString(warning);
  });
  session_.start();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 1);
  EXPECT_EQ(warnings.filter(QStringLiteral("character.glb: is not put on")).size(), 1);
}

TEST_F(BatchInTheStudio, RefusesClipsWithAMessageWhileItRuns) {
  addClips(2, 900);
  session_.start();
  ASSERT_TRUE(session_.running());
  QSignalSpy noted(&session_, &BatchSession::noted);
  session_.addClips({path("clip0.bvh")});
  session_.addTuned({{path("clip1.bvh"), {}, {}}});
  EXPECT_EQ(noted.count(), 2);
  EXPECT_EQ(session_.queue()->rowCount(), 2);
  ASSERT_TRUE(waitForEnd());
}

TEST_F(BatchInTheStudio, EditsAreUndoneAndRedoneStepByStep) {
  addClips(3);
  const Settings fine{.name = "fine", .target = {Target::Kind::Error, 0.2}};
  const Settings usual = session_.queue()->common();
  session_.setOwn({0, 2}, built_in_presets()[3]);
  session_.setCommon(fine);
  session_.remove({0, 1});
  BatchSettings elsewhere = session_.settings();
  elsewhere.folder = path("elsewhere");
  session_.setSettings(elsewhere);
  const auto names = [this] {
    std::string all;
    for (const QueuedClip& clip : session_.queue()->clips())
      all += QFileInfo(QString::fromStdString(clip.source.path)).baseName().back().toLatin1();
    return all;
  };
  EXPECT_EQ(names(), "2");
  const int steps = session_.history().index();
  session_.undo();
  EXPECT_EQ(session_.settings().folder, path("out"));
  session_.undo();
  EXPECT_EQ(names(), "012");
  EXPECT_TRUE(session_.queue()->clips()[0].own && session_.queue()->clips()[2].own);
  session_.undo();
  EXPECT_EQ(session_.queue()->common(), usual);
  session_.undo();
  EXPECT_FALSE(session_.queue()->clips()[0].own || session_.queue()->clips()[2].own);
  while (session_.history().canUndo()) session_.undo();
  EXPECT_EQ(names(), "");
  while (session_.history().canRedo()) session_.redo();
  EXPECT_EQ(session_.history().index(), steps);
  EXPECT_EQ(names(), "2");
  EXPECT_EQ(session_.queue()->common(), fine);
  EXPECT_TRUE(session_.queue()->clips()[0].own);
  EXPECT_EQ(session_.settings().folder, path("elsewhere"));
}

TEST_F(BatchInTheStudio, TypingIsOneStepAndNoChangeIsNone) {
  addClips(1);
  const int steps = session_.history().count();
  session_.setCommon(session_.queue()->common());
  session_.setSettings(session_.settings());
  session_.setOwn({0}, std::nullopt);
  session_.remove({});
  EXPECT_EQ(session_.history().count(), steps);
  session_.addTuned({{path("clip0.bvh"), {}, {}}, {path("clip1.bvh"), {}, {}}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.queue()->rowCount() == 2; }, kPatience));
  EXPECT_EQ(session_.history().count(), steps + 1);
  BatchSettings settings = session_.settings();
  for (const char* names : {"a", "ab", "abc"}) {
    settings.names = QString::fromLatin1(names);
    session_.setSettings(settings);
  }
  EXPECT_EQ(session_.history().count(), steps + 2);
  session_.undo();
  EXPECT_EQ(session_.settings().names, QStringLiteral("{folder}/{stem}"));
}

TEST_F(BatchInTheStudio, WhileItRunsNothingIsUndone) {
  addClips(1, 900);
  session_.start();
  ASSERT_TRUE(session_.running());
  session_.undo();
  session_.remove({0});
  EXPECT_EQ(session_.queue()->rowCount(), 1);
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(count(ClipState::Done), 1);
}

TEST_F(BatchInTheStudio, SettingsOfJointsThatAreNoLongerInTheFileAreLeftOut) {
  addClips(1);
  NamedSettings settings;
  settings.preset.correction = CorrectionSettings{.effectors = {"tail_3"}};
  settings.preset.contacts = {{"tail_3", 1, 2}};
  settings.preset.importance.set("tail_3", 2);
  session_.addTuned({{path("clip0.bvh"), {}, settings}});
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return session_.queue()->clips()[0].own.has_value(); }, kPatience));
  const Settings& own = *session_.queue()->clips()[0].own;
  EXPECT_TRUE(own.correction->effectors.empty());
  EXPECT_TRUE(own.contacts->empty());
  EXPECT_TRUE(own.importance.factors.empty());
}

}  // namespace
}  // namespace mocapress
