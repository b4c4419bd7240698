// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_tree.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeView>
#include <numeric>

#include "widgets/panels/library_panel.h"

namespace mocapress {
namespace {

LibraryEntry entry(const char* path, std::optional<bool> met = {}) {
  LibraryEntry made{.path = QString::fromLatin1(path), .frames = 10};
  if (met) made.outcome = Outcome{25, 0.5, 2, 1000, *met};
  return made;
}

/// The tree as a text: "walks[fast[b] a c]" for folders with their content.
QString textOf(const LibraryTree& tree, const QModelIndex& above = {}) {
  QStringList parts;
  for (int row = 0; row < tree.rowCount(above); ++row) {
    const QModelIndex index = tree.index(row, 0, above);
    const QString name = index.data().toString();
    parts << (tree.clipOf(index) >= 0 ? name
                                      : QStringLiteral("%1[%2]").arg(name, textOf(tree, index)));
  }
  return parts.join(QLatin1Char(' '));
}

class ALibraryTree : public testing::Test {
 protected:
  ALibraryTree() {
    clips_.setEntries({entry("/m/walks/a.bvh", true), entry("/m/walks/fast/b.bvh", false),
                       entry("/m/jumps/deep/er/c.bvh"), entry("/m/walks/d.bvh")});
  }
  LibraryModel clips_;
  LibraryTree tree_{&clips_};
  QAbstractItemModelTester tester_{&tree_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ALibraryTree, PutsClipsBelowTheirFoldersWithoutWhatAllShare) {
  EXPECT_EQ(textOf(tree_).toStdString(), "jumps/deep/er[c.bvh] walks[fast[b.bvh] a.bvh d.bvh]");
}

TEST_F(ALibraryTree, IsAListWhereAllAreInOneFolder) {
  clips_.setEntries({entry("/m/walks/a.bvh"), entry("/m/walks/d.bvh")});
  EXPECT_EQ(textOf(tree_).toStdString(), "a.bvh d.bvh");
}

TEST_F(ALibraryTree, GrowsWithTheLibrary) {
  clips_.setEntry(entry("/m/walks/fast/e.bvh"));
  clips_.addEntries({entry("/n/f.bvh")});
  EXPECT_EQ(textOf(tree_).toStdString(),
            "m[jumps/deep/er[c.bvh] walks[fast[b.bvh e.bvh] a.bvh d.bvh]] n[f.bvh]");
}

TEST_F(ALibraryTree, FindsEveryClipWhereItIs) {
  for (int clip = 0; clip < clips_.rowCount(); ++clip)
    EXPECT_EQ(tree_.clipOf(tree_.indexOf(clip)), clip);
  const QModelIndex walks = tree_.indexOf(0).parent();
  EXPECT_EQ(tree_.clipOf(walks), -1);
  EXPECT_EQ(tree_.clipsBelow(walks), (std::vector<int>{1, 0, 3}));
  EXPECT_EQ(tree_.folderPath(walks).toStdString(), "/m/walks");
}

TEST_F(ALibraryTree, FoldersSayHowManyClipsMissedTheirTarget) {
  const QModelIndex walks = tree_.indexOf(0).parent();
  EXPECT_EQ(tree_.folderSummary(tree_.indexOf(2).parent()).toStdString(), "1 clip(s)");
  EXPECT_EQ(tree_.folderSummary(walks).toStdString(), "3 clip(s), 1 missed");
  QSignalSpy changed(&tree_, &LibraryTree::dataChanged);
  clips_.setEntry(entry("/m/walks/fast/b.bvh", true));
  EXPECT_EQ(changed.count(), 3) << "the clip and both folders above it";
  EXPECT_EQ(tree_.folderSummary(tree_.indexOf(0).parent()).toStdString(), "3 clip(s)");
}

TEST_F(ALibraryTree, FiltersByNameFolderAndState) {
  const auto filtered = [this](const char* words) {
    tree_.setFilter(QString::fromLatin1(words));
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(filtered("WALKS"), "fast[b.bvh] a.bvh d.bvh");
  EXPECT_EQ(filtered("c.bvh"), "c.bvh");
  EXPECT_EQ(filtered("walks missed"), "b.bvh");
  EXPECT_EQ(filtered("nothing"), "");
  EXPECT_FALSE(tree_.indexOf(0).isValid());
  tree_.setFilter(QStringLiteral("missed"));
  clips_.setEntry(entry("/m/walks/fast/b.bvh", true));
  EXPECT_EQ(textOf(tree_).toStdString(), "");
}

TEST_F(ALibraryTree, ThePanelKeepsWhatIsCollapsedAndChosen) {
  LibraryPanel panel(&clips_);
  QTreeView* view = panel.view();
  LibraryTree* tree = panel.tree();
  panel.setCurrent(2);
  EXPECT_TRUE(view->isExpanded(tree->indexOf(2).parent()));
  view->collapse(tree->indexOf(0).parent());
  clips_.setEntry(entry("/m/walks/fast/e.bvh"));
  EXPECT_FALSE(view->isExpanded(tree->indexOf(0).parent()));
  EXPECT_TRUE(view->isExpanded(tree->indexOf(2).parent()));
  EXPECT_EQ(tree->clipOf(view->currentIndex()), 2);
  QSignalSpy opened(&panel, &LibraryPanel::openRequested);
  panel.filter()->setText(QStringLiteral("walks"));
  panel.filter()->clear();
  EXPECT_EQ(tree->clipOf(view->currentIndex()), 2);
  EXPECT_EQ(opened.count(), 0);
}

TEST_F(ALibraryTree, AFolderIsRemovedWithAllThatIsInIt) {
  LibraryPanel panel(&clips_);
  QSignalSpy removed(&panel, &LibraryPanel::removeRequested);
  QSignalSpy opened(&panel, &LibraryPanel::openRequested);
  panel.view()->setCurrentIndex(panel.tree()->indexOf(0).parent());
  EXPECT_EQ(opened.count(), 0) << "a folder is no clip";
  panel.removeButton()->click();
  ASSERT_EQ(removed.count(), 1);
  EXPECT_EQ(removed[0][0].value<QList<int>>(), (QList<int>{1, 0, 3}));
}

TEST_F(ALibraryTree, AllThatIsSelectedIsChosenAndStaysSoWhenOneOfThemIsCurrent) {
  LibraryPanel panel(&clips_);
  panel.setCurrent(0);
  QItemSelectionModel* selection = panel.view()->selectionModel();
  for (const int clip : {2, 1})  // selects as with Ctrl
    selection->setCurrentIndex(panel.tree()->indexOf(clip), QItemSelectionModel::Select);
  EXPECT_EQ(panel.chosenRows().size(), 3u);
  panel.setCurrent(1);
  EXPECT_EQ(panel.chosenRows().size(), 3u);
  panel.setCurrent(2);
  EXPECT_EQ(panel.chosenRows().size(), 3u);
  QSignalSpy removed(&panel, &LibraryPanel::removeRequested);
  panel.removeButton()->click();
  ASSERT_EQ(removed.count(), 1);
  EXPECT_EQ(removed[0][0].value<QList<int>>().size(), 3);
  panel.setCurrent(3);
  EXPECT_EQ(panel.chosenRows(), std::vector<int>{3}) << "another clip is chosen alone";
  // A selected folder and a clip in it count each clip once.
  selection->select(panel.tree()->indexOf(0).parent(), QItemSelectionModel::Select);
  EXPECT_EQ(panel.chosenRows().size(), 3u);
}

}  // namespace
}  // namespace mocapress
