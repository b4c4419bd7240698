// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDir>
#include <QHeaderView>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "app/studio/document/session.h"
#include "app/studio/library/background_encoding.h"
#include "app/studio/library/library.h"
#include "core/batch/batch_folder.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_columns.h"
#include "widgets/models/library_tree.h"
#include "widgets/panels/library_panel.h"

namespace mocapress::library_comparison_test {
namespace {

Settings standard(double ratio) {
  Settings settings{.name = "Mine", .method = "standard"};
  settings.target = {Target::Kind::Ratio, ratio};
  return settings;
}

/// Three clips that are compressed 10:1.
class AComparedLibrary : public testing::Test {
 protected:
  AComparedLibrary() {
    const QDir folder(QDir(directory_.path()).canonicalPath());
    for (unsigned i = 0; i < 3; ++i) {
      paths_ << folder.filePath(QStringLiteral("clip%1.bvh").arg(i));
      write_motion(paths_.back().toStdU16String(), test::smooth_motion(120, i + 1));
    }
    library_.beginEmpty(folder.filePath(QStringLiteral("data")));
    library_.add(paths_);
    compressAll({10, 10, 10});
  }

  void compressAll(const std::vector<double>& ratios) {
    for (int row = 0; row < 3; ++row)
      library_.setPreset({row}, standard(ratios[static_cast<std::size_t>(row)]));
    BackgroundEncoding encoding(&session_, &library_);
    encoding.setActive(true);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          for (int row = 0; row < 3; ++row)
            if (!model_.entry(row).outcome || model_.entry(row).outdated != Staleness::None)
              return false;
          return true;
        },
        kPatience));
  }

  /// The text that tells of it.
  QString compareWith(const QString& path) {
    QSignalSpy noted(&library_, &Library::noted);
    library_.compareWith(path);
    EXPECT_TRUE(QTest::qWaitFor([&] { return noted.count() > 0; }, kPatience));
    return noted.value(0).value(0).toString();
  }

  QString text(int row, LibraryColumn column) const { return textOf(model_.entry(row), column); }

  QTemporaryDir directory_;
  QStringList paths_;
  Session session_;
  LibraryModel model_;
  Library library_{&session_, &model_};
};

TEST_F(AComparedLibrary, SaysWhatChangedSinceAnEarlierBatch) {
  const QString folder = directory_.filePath(QStringLiteral("farm"));
  Batch batch{.presets = {standard(10), standard(20)}};
  for (std::size_t i = 0; i < 2; ++i)
    batch.items.push_back({.input = paths_[static_cast<int>(i)].toStdString(),
                           .output = std::to_string(i),
                           .preset = i});
  BatchControl control;
  const BatchOutcome outcome = run_batch_in(folder.toStdU16String(), batch, {}, control);
  ASSERT_EQ(outcome.counts.done, 2u);
  visit_rows(folder.toStdU16String(), [](const BatchRow& row) { EXPECT_EQ(row.error, ""); });
  const QString told = compareWith(folder + QStringLiteral("/batch.jsonl"));
  EXPECT_TRUE(told.contains(QStringLiteral("2 clip"))) << qPrintable(told);
  EXPECT_TRUE(told.contains(QStringLiteral("farm"))) << qPrintable(told);
  EXPECT_TRUE(told.contains(QStringLiteral("1 larger"))) << qPrintable(told);
  EXPECT_EQ(text(0, LibraryColumn::Since), QString()) << "as it was";
  EXPECT_TRUE(text(1, LibraryColumn::Since).contains(QStringLiteral("larger")));
  EXPECT_TRUE(text(1, LibraryColumn::BytesSince).startsWith(QLatin1Char('+')));
  EXPECT_TRUE(text(1, LibraryColumn::ErrorSince).startsWith(QStringLiteral("−")));
  EXPECT_EQ(text(2, LibraryColumn::BytesSince), QString()) << "the batch does not have it";
  // The comparison follows the clip.
  compressAll({10, 20, 10});
  EXPECT_EQ(text(1, LibraryColumn::Since), QString());
}

TEST_F(AComparedLibrary, SaysWhatChangedSinceAnEarlierProjectInColumnsOfTheList) {
  const QString earlier = directory_.filePath(QStringLiteral("before.mocapress"));
  writeProject(earlier, library_.project());
  compressAll({10, 5, 20});
  LibraryPanel panel(&model_);
  const int changes = static_cast<int>(LibraryColumn::Since);
  EXPECT_TRUE(panel.view()->isColumnHidden(changes));
  compareWith(earlier);
  panel.showComparison(true);
  EXPECT_FALSE(panel.view()->isColumnHidden(changes));
  EXPECT_EQ(panel.tree()->clipsBelow({}).back(), 0) << "what did not change comes last";
  EXPECT_TRUE(text(1, LibraryColumn::Since).contains(QStringLiteral("larger")));
  EXPECT_TRUE(text(2, LibraryColumn::Since).contains(QStringLiteral("smaller")));
  panel.showComparison(false);
  EXPECT_TRUE(panel.view()->isColumnHidden(changes));
}

TEST_F(AComparedLibrary, HasTheOrderOfTheUserAgainAfterTheComparison) {
  LibraryPanel panel(&model_);
  const int bytes = static_cast<int>(LibraryColumn::Bytes);
  panel.view()->sortByColumn(bytes, Qt::DescendingOrder);
  panel.showComparison(true);
  EXPECT_EQ(panel.view()->header()->sortIndicatorSection(), static_cast<int>(LibraryColumn::Since));
  LibraryPanel next_run(&model_);
  next_run.arrange(panel.arrangement());
  EXPECT_EQ(next_run.view()->header()->sortIndicatorSection(), bytes);
  EXPECT_EQ(panel.view()->header()->sortIndicatorSection(), static_cast<int>(LibraryColumn::Since));
  panel.showComparison(false);
  EXPECT_EQ(panel.view()->header()->sortIndicatorSection(), bytes);
  EXPECT_EQ(panel.view()->header()->sortIndicatorOrder(), Qt::DescendingOrder);
}

TEST_F(AComparedLibrary, FindsClipsThatMovedByTheirNames) {
  Project elsewhere = library_.project();
  for (ProjectClip& clip : elsewhere.clips)
    clip.path = QStringLiteral("/farm") + clip.path.mid(clip.path.lastIndexOf(QLatin1Char('/')));
  elsewhere.clips.push_back(elsewhere.clips[2]);  // two with one name
  elsewhere.clips.back().path.prepend(QStringLiteral("/other"));
  const QString earlier = directory_.filePath(QStringLiteral("farm.mocapress"));
  writeProject(earlier, elsewhere);
  compareWith(earlier);
  EXPECT_TRUE(model_.entry(0).since);
  EXPECT_TRUE(model_.entry(1).since);
  EXPECT_FALSE(model_.entry(2).since);
}

TEST_F(AComparedLibrary, ComparesAClipThatComesBackWithThePresentBatch) {
  const QString first = directory_.filePath(QStringLiteral("first.mocapress"));
  writeProject(first, library_.project());
  compareWith(first);
  EXPECT_TRUE(model_.entry(0).since);
  library_.remove({0});
  const QString second = directory_.filePath(QStringLiteral("second.mocapress"));
  writeProject(second, library_.project());
  compareWith(second);
  library_.history()->undo();
  ASSERT_EQ(model_.rowCount(), 3);
  EXPECT_FALSE(model_.entry(0).since) << "the second does not have it";
  EXPECT_TRUE(model_.entry(1).since);
}

TEST_F(AComparedLibrary, ComparesTakesThatAreFoundAfterwards) {
  const QString moves = directory_.filePath(QStringLiteral("moves.fbx"));
  const Motion idle = test::smooth_motion(60, 1), run = test::smooth_motion(90, 2);
  write_takes(moves.toStdU16String(), {{"Idle", idle, {}}, {"Run", run, {}}});
  Project before = library_.project();
  for (const char* take : {"Idle", "Run"}) {
    before.clips.push_back({.path = moves, .outcome = before.clips[0].outcome});
    before.clips.back().reading.take = take;
  }
  const QString earlier = directory_.filePath(QStringLiteral("before.mocapress"));
  writeProject(earlier, before);
  compareWith(earlier);
  library_.add({moves});
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_.rowCount() == 5; }, kPatience));
  for (const std::size_t row : {3u, 4u}) EXPECT_TRUE(library_.project().clips[row].earlier) << row;
}

TEST_F(AComparedLibrary, SaysWhyAFolderIsNoBatch) {
  QSignalSpy failed(&library_, &Library::failed);
  library_.compareWith(directory_.path());
  EXPECT_TRUE(QTest::qWaitFor([&] { return failed.count() > 0; }, kPatience));
}

}  // namespace
}  // namespace mocapress::library_comparison_test
