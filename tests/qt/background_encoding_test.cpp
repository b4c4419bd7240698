// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/background_encoding.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <optional>

#include "app/jobs/batch_runner.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_model.h"
#include "widgets/panels/encoding_bar.h"

namespace mocapress {
namespace {

Settings standard(double ratio) {
  Settings settings{.method = "standard"};
  settings.target = {Target::Kind::Ratio, ratio};
  return settings;
}

class ALibraryInTheBackground : public testing::Test {
 protected:
  ALibraryInTheBackground() {
    for (unsigned i = 0; i < 3; ++i) {
      const QString path = QDir(QDir(directory_.path()).canonicalPath())
                               .filePath(QStringLiteral("clip%1.bvh").arg(i));
      write_motion(path.toStdU16String(), test::smooth_motion(120, i + 1));
      paths_ << path;
    }
    library_.beginEmpty(directory_.filePath(QStringLiteral("data")));
    library_.add(paths_);
    library_.setPreset({0, 1, 2}, standard(10));
  }

  bool isDone(int row) const {
    const LibraryEntry& entry = model_.entry(row);
    return entry.outcome && entry.outdated == Staleness::None;
  }

  bool waitForAll() {
    return QTest::qWaitFor([&] { return isDone(0) && isDone(1) && isDone(2); }, kPatience);
  }

  bool waitForOutlines() {
    return QTest::qWaitFor(
        [&] { return library_.unencoded(9).size() == 3 && !project(0).stamp.source.empty(); },
        kPatience);
  }

  const ProjectClip& project(std::size_t row) const { return library_.project().clips[row]; }

  QTemporaryDir directory_;
  QStringList paths_;
  Session session_;
  LibraryModel model_;
  Library library_{&session_, &model_};
};

TEST_F(ALibraryInTheBackground, EveryRowGetsTheResultsOfItsOwnSettings) {
  library_.setPreset({1}, standard(20));
  BackgroundEncoding encoding(&session_, &library_);
  encoding.setActive(true);
  ASSERT_TRUE(waitForAll());
  EXPECT_NEAR(model_.entry(0).outcome->ratio, 10, 0.5);
  EXPECT_NEAR(model_.entry(1).outcome->ratio, 20, 0.7);
  EXPECT_GT(model_.entry(2).outcome->motion_bytes, 0u);
  EXPECT_TRUE(model_.entry(2).outcome->sight);
  EXPECT_TRUE(library_.unencoded(9).empty());
}

TEST_F(ALibraryInTheBackground, NewSettingsAreCompressedAgainAndOldOnesAreKnown) {
  BackgroundEncoding encoding(&session_, &library_);
  encoding.setActive(true);
  ASSERT_TRUE(waitForAll());
  encoding.setActive(false);
  const Outcome first = *model_.entry(0).outcome;
  library_.setPreset({0}, standard(30));
  EXPECT_FALSE(isDone(0));
  EXPECT_EQ(library_.unencoded(9).size(), 1u);
  library_.history()->undo();
  EXPECT_TRUE(isDone(0));
  EXPECT_EQ(model_.entry(0).outcome, first);
  library_.history()->redo();
  encoding.setActive(true);
  ASSERT_TRUE(waitForAll());
  EXPECT_NEAR(model_.entry(0).outcome->ratio, 30, 1.5);
}

TEST_F(ALibraryInTheBackground, AResultOfOlderSettingsIsDropped) {
  ASSERT_TRUE(waitForOutlines());
  const TunedClip as_begun = library_.unencoded(1).front();
  library_.setPreset({0}, standard(30));
  BatchStep step{.ended = true, .source = project(0).stamp.source, .measured = Measurement{}};
  library_.noteEncoded(as_begun, step);
  EXPECT_FALSE(model_.entry(0).outcome);
  step.measured.reset();
  step.error = "too much was asked for";
  library_.noteEncoded(as_begun, step);
  EXPECT_EQ(model_.entry(0).failure, QString());
}

TEST_F(ALibraryInTheBackground, AFailureStandsInTheRowAndWaitsForOtherSettings) {
  ASSERT_TRUE(waitForOutlines());
  library_.noteEncoded(library_.unencoded(1).front(),
                       {.ended = true, .error = "too much was asked for"});
  EXPECT_EQ(stateOf(model_.entry(0)), RowState::Bad);
  EXPECT_TRUE(
      model_.index(0, 0).data(Qt::ToolTipRole).toString().contains(QLatin1String("too much")));
  EXPECT_EQ(library_.unencoded(9).size(), 2u);
  library_.setPreset({0}, standard(30));
  EXPECT_EQ(library_.unencoded(9).size(), 3u);
}

TEST_F(ALibraryInTheBackground, RowsInSightComeFirstThenTheShortestClips) {
  const int lengths[] = {200, 150, 100};
  for (int i = 0; i < 3; ++i) {
    paths_ << QFileInfo(paths_[0]).dir().filePath(QStringLiteral("length%1.bvh").arg(i));
    write_motion(paths_.back().toStdU16String(),
                 test::smooth_motion(lengths[i], static_cast<unsigned>(i)));
  }
  library_.add(paths_);
  library_.setPreset({3, 4, 5}, standard(10));
  ASSERT_TRUE(QTest::qWaitFor([&] { return library_.unencoded(9).size() == 6; }, kPatience));
  library_.openClip(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_.isOpen(paths_[0]); }, kPatience));
  const auto order = [&](const std::vector<int>& in_sight) {
    std::vector<int> rows;
    for (const TunedClip& clip : library_.unencoded(9, in_sight))
      rows.push_back(static_cast<int>(paths_.indexOf(clip.path)));
    return rows;
  };
  EXPECT_EQ(order({}), (std::vector<int>{5, 1, 2, 4, 3})) << "the session compresses the open one";
  EXPECT_EQ(order({3, 2}), (std::vector<int>{3, 2, 5, 1, 4}));
  EXPECT_EQ(library_.unencoded(2).size(), 2u);
}

TEST_F(ALibraryInTheBackground, PausesAndEndsWithWhatIsUnderWay) {
  std::optional<BackgroundEncoding> encoding(std::in_place, &session_, &library_);
  QSignalSpy active(&*encoding, &BackgroundEncoding::activeChanged);
  encoding->setActive(true);
  encoding->setActive(false);
  encoding->setActive(true);
  EXPECT_EQ(active.count(), 3);
  QSignalSpy results(&model_, &LibraryModel::dataChanged);
  ASSERT_TRUE(results.wait(kPatience));
  encoding->setActive(false);
  encoding.reset();  // hangs where a worker that is paused is waited for
  library_.startNew();
  EXPECT_EQ(model_.rowCount(), 0);
}

TEST_F(ALibraryInTheBackground, SettingsAreCopiedToTheSelectionInOneStep) {
  Settings careful = standard(25);
  careful.importance.set("feet", 4);
  library_.setPreset({0}, careful);
  EXPECT_FALSE(library_.hasCopy());
  library_.copySettings(0);
  library_.pasteImportance({1, 2});
  EXPECT_EQ(project(1).settings->preset.importance, careful.importance);
  EXPECT_DOUBLE_EQ(project(1).settings->preset.target.value, 10);
  EXPECT_EQ(library_.history()->undoText(), QStringLiteral("Paste Importance, 2 Clip(s)"));
  library_.pasteSettings({0, 1, 2});
  EXPECT_EQ(project(2).settings->preset, careful);
  library_.history()->undo();
  EXPECT_DOUBLE_EQ(project(1).settings->preset.target.value, 10);
  library_.history()->undo();
  EXPECT_TRUE(project(2).settings->preset.importance.is_even());
}

TEST_F(ALibraryInTheBackground, RangesAndLoopStayWithTheirClip) {
  Settings own = standard(25);
  own.ranges = {{2, 5, 3}};
  own.loop = Loop::None;
  library_.setPreset({0}, own);
  library_.copySettings(0);
  library_.pasteSettings({1});
  EXPECT_DOUBLE_EQ(project(1).settings->preset.target.value, 25);
  EXPECT_TRUE(project(1).settings->preset.ranges.empty());
  EXPECT_FALSE(project(1).settings->preset.loop);
  library_.setPreset({0}, standard(30));
  EXPECT_EQ(project(0).settings->preset.ranges, own.ranges);
  EXPECT_EQ(project(0).settings->preset.loop, Loop::None);
}

TEST_F(ALibraryInTheBackground, ShowsTheBytesBeforeAndAfterAChangeOfSettings) {
  BackgroundEncoding encoding(&session_, &library_);
  encoding.setActive(true);
  ASSERT_TRUE(waitForAll());
  const std::size_t before = model_.entry(0).outcome->motion_bytes;
  library_.setPreset({0, 1}, standard(40));
  ASSERT_TRUE(waitForAll());
  EXPECT_EQ(model_.entry(0).bytes_before, before);
  EXPECT_LT(model_.entry(0).outcome->motion_bytes, before);
  EXPECT_FALSE(model_.entry(2).bytes_before);
}

TEST_F(ALibraryInTheBackground, TheBarCountsWhatIsDoneAndStartsAndPauses) {
  EncodingBar bar(&model_);
  BackgroundEncoding encoding(&session_, &library_);
  QObject::connect(&bar, &EncodingBar::activeChosen, &encoding, &BackgroundEncoding::setActive);
  bar.button()->click();
  EXPECT_TRUE(encoding.active());
  ASSERT_TRUE(waitForAll());
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar.progress()->value() == 3; }, kPatience));
  EXPECT_EQ(bar.progress()->format(), QStringLiteral("3 of 3 compressed"));
  bar.button()->click();
  EXPECT_FALSE(encoding.active());
}

}  // namespace
}  // namespace mocapress
