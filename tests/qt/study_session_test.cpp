// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_session.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/studio/study/study_window.h"
#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "core/study/row.h"
#include "core/study/study_folder.h"
#include "tests/qt/patience.h"
#include "tests/qt/well_formed.h"
#include "tests/support/svg_frame.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using State = StudySession::State;

class StudySessionTest : public testing::Test {
 protected:
  StudySessionTest() {
    QObject::connect(&session_, &StudySession::rowsAdded,
                     [this](const std::vector<StudyRow>& rows) { arrived_ += rows.size(); });
  }

  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }

  QString writeClip(const char* name, int frames) const {
    write_motion(path(name).toStdU16String(), test::smooth_motion(frames));
    return path(name);
  }

  /// Settings with quick methods.
  StudySettings settings(const QStringList& clips) const {
    StudySettings settings;
    settings.clips = clips;
    settings.methods = {QStringLiteral("standard"), QStringLiteral("subsample")};
    settings.ratios = {5, 10};
    return settings;
  }

  bool waitForEnd() {
    return QTest::qWaitFor([this] { return !session_.running(); }, kPatience);
  }

  void run(const StudySettings& settings) {
    session_.setSettings(settings);
    session_.run();
    ASSERT_TRUE(session_.running());
    ASSERT_TRUE(waitForEnd());
  }

  QByteArray written(const QString& file) {
    QSignalSpy exported(&session_, &StudySession::exported);
    EXPECT_TRUE(exported.count() > 0 || exported.wait(kPatience));
    QFile content(file);
    return content.open(QIODevice::ReadOnly) ? content.readAll() : QByteArray();
  }

  QTemporaryDir directory_;
  StudySession session_{directory_.filePath(QStringLiteral("cache"))};
  std::size_t arrived_ = 0;
};

using StudyInTheStudio = StudySessionTest;

TEST_F(StudyInTheStudio, HandsOverEveryRowOnce) {
  run(settings({writeClip("one.bvh", 120), writeClip("two.bvh", 130)}));
  EXPECT_EQ(session_.state(), State::Complete);
  EXPECT_EQ(arrived_, 8u);
  ASSERT_EQ(session_.rows().size(), 8u);
  EXPECT_EQ(session_.rows()[0].settings.method, "standard");
  EXPECT_EQ(session_.rows()[7].settings.method, "subsample");
  EXPECT_EQ(session_.completeClips().size(), 2u);
  for (const StudyRow& row : session_.rows()) EXPECT_TRUE(row.measured) << row.error;
}

TEST_F(StudyInTheStudio, MeasuresNothingTwice) {
  const StudySettings first = settings({writeClip("one.bvh", 120)});
  run(first);
  StudySettings more = first;
  more.ratios.push_back(20);
  run(more);
  EXPECT_EQ(session_.counts().done, 6);
  EXPECT_EQ(session_.counts().kept, 4);
}

TEST_F(StudyInTheStudio, CancelKeepsWhatIsDoneAndTheNextRunGoesOn) {
  StudySettings long_one = settings({writeClip("one.bvh", 800)});
  long_one.methods = {QStringLiteral("annealed")};
  long_one.ratios = {3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 25, 30, 35, 40, 45, 50, 60};
  session_.setSettings(long_one);
  session_.run();
  ASSERT_TRUE(QTest::qWaitFor([this] { return arrived_ > 0; }, kPatience));
  session_.cancel();
  ASSERT_TRUE(waitForEnd());
  EXPECT_EQ(session_.state(), State::Cancelled);
  const std::size_t done = session_.rows().size();
  EXPECT_EQ(done, arrived_);
  EXPECT_LT(done, 20u);
  EXPECT_TRUE(session_.completeClips().empty());

  // Rows are made in parallel, so the finished ones need not be the plan's first.
  long_one.ratios.clear();
  for (const StudyRow& row : session_.rows()) long_one.ratios.push_back(row.settings.target.value);
  run(long_one);
  EXPECT_EQ(session_.state(), State::Complete);
  EXPECT_EQ(session_.counts().kept, static_cast<int>(done));
}

TEST_F(StudyInTheStudio, ItsReportIsWellFormedAndItsPicturesFillTheirFrames) {
  StudySettings wavelets =
      settings({QStringLiteral(MOCAPRESS_SOURCE_DIR "/resources/samples/human_walk.amc")});
  wavelets.methods = {QStringLiteral("standard"), QStringLiteral("haar")};
  run(wavelets);
  const QString file = path("study.html");
  session_.exportReport(file);
  const QByteArray page = written(file);
  EXPECT_EQ(test::ill_formed(QString::fromUtf8(page)), "");
  EXPECT_EQ(test::misfit(page.toStdString()), "");
  EXPECT_TRUE(page.contains("class=\"scene\""));
}

TEST_F(StudyInTheStudio, ItsTablesCarryWhatTheLibrarySays) {
  const QString clip = writeClip("one.bvh", 120);
  const auto said = [](Verdict verdict, const char* note) {
    return ClipReview{verdict, note, "ann", "2026-11-27T01:39:46Z", "1", "2"};
  };
  session_.setReviews({{clip, {said(Verdict::Rejected, "slides"), "1"}}});
  run(settings({clip}));
  EXPECT_EQ(session_.rows()[0].review.verdict, Verdict::Rejected);
  EXPECT_EQ(session_.rows()[0].review.note, "slides");
  session_.setReviews({{clip, {said(Verdict::Approved, "mended"), "1"}}});
  const QString file = path("rows.csv");
  session_.exportRows(file);
  EXPECT_TRUE(written(file).contains(",approved,mended,"));
  // The verdict was on other bytes.
  session_.setReviews({{clip, {said(Verdict::Approved, "mended"), "another"}}});
  session_.exportRows(file);
  const QByteArray table = written(file);
  EXPECT_FALSE(table.contains(",approved,"));
  EXPECT_TRUE(table.contains("file changed"));
}

TEST_F(StudyInTheStudio, ItsTablesCarryTheReviewsOfAllTakesOfAFile) {
  const QString clip = writeClip("one.bvh", 120);
  const auto said = [](Verdict verdict, const char* note) {
    return LibraryReview{ClipReview{verdict, note, "ann", "2026-11-27T01:39:46Z", "1", "2"}, "1"};
  };
  const auto shown = [&](const ClipReviews& reviews) {
    session_.setReviews(reviews);
    const QString file = path("takes.csv");
    session_.exportRows(file);
    return written(file);
  };
  run(settings({clip}));
  const QByteArray differing =
      shown({{clipKey(clip, "Run"), said(Verdict::Rejected, "slides")},
             {clipKey(clip, "Walk"), said(Verdict::Approved, "")},
             {clipKey(clip + QStringLiteral("x"), "Jump"), said(Verdict::Approved, "high")}});
  EXPECT_TRUE(differing.contains("Run: rejected, slides; Walk: approved")) << differing.data();
  EXPECT_FALSE(differing.contains(",approved,"));
  EXPECT_FALSE(differing.contains("high"));
  EXPECT_TRUE(shown({{clipKey(clip, "Run"), said(Verdict::Approved, "")},
                     {clipKey(clip, "Walk"), said(Verdict::Approved, "")}})
                  .contains(",approved,"));
}

TEST_F(StudyInTheStudio, ANewerRunVoidsTheOlder) {
  StudySettings older = settings({writeClip("one.bvh", 900)});
  older.methods = {QStringLiteral("annealed")};
  session_.setSettings(older);
  session_.run();
  run(settings({writeClip("two.bvh", 100)}));
  ASSERT_EQ(session_.rows().size(), 4u);
  for (const StudyRow& row : session_.rows()) EXPECT_TRUE(row.clip.ends_with("two.bvh"));
}

TEST_F(StudyInTheStudio, AClipThatCannotBeReadIsInTheRowsAndStopsNothing) {
  run(settings({path("missing.bvh"), writeClip("one.bvh", 100)}));
  EXPECT_EQ(session_.state(), State::Complete);
  ASSERT_EQ(session_.rows().size(), 8u);
  EXPECT_FALSE(session_.rows()[0].error.empty());
  EXPECT_TRUE(session_.rows()[7].measured);
  EXPECT_TRUE(statusOf(session_).contains(QStringLiteral("cannot be read")));
}

TEST_F(StudyInTheStudio, AddsTheClipsBelowAFolderOnceAndSaysWhatIsNone) {
  writeClip("one.bvh", 50);
  writeClip("two.bvh", 50);
  session_.addClips({path("two.bvh")});
  session_.addClips({directory_.path()});
  ASSERT_TRUE(QTest::qWaitFor([this] { return session_.settings().clips.size() == 2; }));
  session_.removeClips({path("one.bvh")});
  EXPECT_EQ(session_.settings().clips, QStringList{path("two.bvh")});
  QSignalSpy failed(&session_, &StudySession::addFailed);
  session_.addClips({path("not there.bvh")});
  ASSERT_TRUE(failed.wait(kPatience));
  EXPECT_TRUE(failed[0][0].toString().contains(QStringLiteral("not there.bvh")));
}

TEST_F(StudyInTheStudio, WritesAFolderThatTheCommandLineGoesOnWithAndShowsItAgain) {
  const QString folder = path("kept");
  session_.setFolder(folder);
  run(settings({writeClip("one.bvh", 120)}));
  for (const char* name : {kRowsSoFar, kRowsCsv, kRowsJson, kReport})
    EXPECT_TRUE(QFile::exists(folder + QLatin1Char('/') + QLatin1String(name))) << name;

  StudySession other(path("another cache"));
  other.setFolder(folder);
  ASSERT_TRUE(QTest::qWaitFor([&] { return other.state() == State::Opened; }, kPatience));
  EXPECT_EQ(rows_csv(other.rows()).size(), rows_csv(session_.rows()).size());
  EXPECT_EQ(other.completeClips(), session_.completeClips());
}

TEST_F(StudyInTheStudio, AFolderThatCannotBeWrittenIsAMessage) {
  ASSERT_TRUE(QFile(path("file")).open(QIODevice::WriteOnly));
  session_.setFolder(path("file/folder"));
  run(settings({writeClip("one.bvh", 50)}));
  EXPECT_EQ(session_.state(), State::Failed);
  EXPECT_TRUE(statusOf(session_).contains(path("file/folder")));
}

TEST_F(StudyInTheStudio, ExportsRowsAndReport) {
  run(settings({writeClip("one.bvh", 120)}));
  session_.exportRows(path("rows.csv"));
  EXPECT_EQ(written(path("rows.csv")).toStdString(), rows_csv(session_.rows()));
  session_.exportReport(path("report.html"));
  EXPECT_TRUE(session_.exporting());
  const QByteArray report = written(path("report.html"));
  EXPECT_TRUE(report.contains("<svg")) << report.size();
  EXPECT_TRUE(report.contains("Frame subsampling"));
  session_.exportFile(path("plot.png"), "picture");
  EXPECT_EQ(written(path("plot.png")), QByteArray("picture"));
}

TEST_F(StudyInTheStudio, AnExportThatFailsIsAMessageAndLeavesNothing) {
  run(settings({writeClip("one.bvh", 100)}));
  QSignalSpy failed(&session_, &StudySession::exportFailed);
  session_.exportRows(path("no/such/folder/rows.csv"));
  ASSERT_TRUE(failed.wait(kPatience));
  session_.exportFile(path("plot.png"), {});
  EXPECT_EQ(failed.count(), 2);
  EXPECT_FALSE(QFile::exists(path("plot.png")));
}

TEST_F(StudyInTheStudio, SaysWhatIsMissingBeforeItCanRun) {
  EXPECT_EQ(session_.jobs(), 0);
  session_.run();
  EXPECT_EQ(session_.state(), State::Idle);
  const QString no_clip = statusOf(session_);
  session_.setSettings(settings({path("one.bvh")}));
  EXPECT_EQ(session_.jobs(), 4);
  EXPECT_NE(statusOf(session_), no_clip);
}

TEST_F(StudyInTheStudio, CanBeDroppedInTheMiddleOfARun) {
  StudySettings long_one = settings({writeClip("one.bvh", 1200)});
  long_one.methods = {QStringLiteral("annealed"), QStringLiteral("pca")};
  for (const std::size_t rows : {0, 1, 2}) {
    StudySession brief(path("brief"));
    brief.setSettings(long_one);
    brief.run();
    ASSERT_TRUE(QTest::qWaitFor([&] { return brief.rows().size() >= rows; }, kPatience));
  }
  StudySession later(path("brief"));  // its rows were released and are complete
  later.setSettings(settings({writeClip("two.bvh", 120)}));
  later.run();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !later.running(); }, kPatience));
  EXPECT_EQ(later.state(), State::Complete) << later.failure().toStdString();
  EXPECT_EQ(later.rows().size(), 4u);
}

TEST(StudyMemory, RemembersAllButTheClips) {
  StudySettings settings = usualStudySettings();
  settings.methods = {QStringLiteral("pca")};
  settings.errors = {0.25};
  settings.ik_ratio = 12;
  settings.weighting = Weighting::JointOrigins;
  remember(settings);
  EXPECT_EQ(rememberedStudySettings(), settings);
}

}  // namespace
}  // namespace mocapress
