// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/library_tree.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeView>
#include <algorithm>
#include <numeric>

#include "widgets/panels/elided_label.h"
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
  clips_.insert(clips_.rowCount(), {entry("/n/f.bvh")});
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

TEST_F(ALibraryTree, SortsByAnyColumnAndByNoneAsTheLibraryHasThem) {
  LibraryEntry small = entry("/m/walks/a.bvh", true);
  small.outcome->motion_bytes = 10;
  small.outcome->ratio = 9;
  LibraryEntry large = entry("/m/walks/d.bvh", true);
  large.outcome->motion_bytes = 5000;
  large.outcome->ratio = 100;
  clips_.setEntries({large, small, entry("/m/walks/b.bvh")});
  const auto sorted = [this](LibraryColumn column, Qt::SortOrder order) {
    tree_.sort(static_cast<int>(column), order);
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(sorted(LibraryColumn::Bytes, Qt::AscendingOrder), "b.bvh a.bvh d.bvh");
  EXPECT_EQ(sorted(LibraryColumn::Ratio, Qt::DescendingOrder), "d.bvh a.bvh b.bvh");
  EXPECT_EQ(sorted(LibraryColumn::Clip, Qt::AscendingOrder), "a.bvh b.bvh d.bvh");
  small.outcome->ratio = 200;
  clips_.setEntry(small);
  EXPECT_EQ(sorted(LibraryColumn::Ratio, Qt::DescendingOrder), "a.bvh d.bvh b.bvh");
  tree_.sort(-1, Qt::AscendingOrder);
  EXPECT_EQ(textOf(tree_).toStdString(), "d.bvh a.bvh b.bvh");
}

TEST_F(ALibraryTree, FollowsWhatARowIsSortedAndGroupedBy) {
  clips_.setEntries({entry("/m/a.bvh", true), entry("/m/b.bvh", true), entry("/m/c.bvh", true)});
  tree_.sort(static_cast<int>(LibraryColumn::Ratio), Qt::AscendingOrder);
  LibraryEntry best = clips_.entry(0);
  best.outcome->ratio = 99;
  clips_.setEntry(best);
  EXPECT_EQ(textOf(tree_).toStdString(), "b.bvh c.bvh a.bvh");
  tree_.setGrouping(Grouping::Verdict);
  EXPECT_EQ(textOf(tree_).toStdString(), "Not reviewed[b.bvh c.bvh a.bvh]");
  best.review.verdict = Verdict::Approved;
  clips_.setEntry(best);
  EXPECT_EQ(textOf(tree_).toStdString(), "Approved[a.bvh] Not reviewed[b.bvh c.bvh]");
  best.outcome->sight = Sight::Visible;
  clips_.setEntry(best);
  tree_.setGrouping(Grouping::Seen);
  EXPECT_EQ(textOf(tree_).toStdString(), "not known[b.bvh c.bvh] visible[a.bvh]");
  tree_.setGrouping(Grouping::None);
  EXPECT_EQ(textOf(tree_).toStdString(), "b.bvh c.bvh a.bvh");
}

TEST_F(ALibraryTree, GroupsByEachColumnInTheOrderOfItsNumbers) {
  LibraryEntry a = entry("/m/a.bvh", true), b = entry("/m/b.bvh", true), c = entry("/m/c.bvh");
  a.outcome->ratio = 120;
  b.outcome->ratio = 30;
  a.outcome->eps_cm = 0.003;
  b.outcome->eps_cm = 0.6;
  a.notes << QStringLiteral("guessed");
  a.sample_rate_hz = 5;
  b.preset = QStringLiteral("Archive");
  clips_.setEntries({a, b, c});
  const auto grouped = [this](Grouping grouping) {
    tree_.setGrouping(grouping);
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(grouped(Grouping::Ratio), "20 to 50[b.bvh] 100 to 200[a.bvh] not known[c.bvh]");
  EXPECT_EQ(grouped(Grouping::Error), "below 0.1 mm[a.bvh] 5 mm to 1 cm[b.bvh] not known[c.bvh]");
  EXPECT_EQ(grouped(Grouping::Warned), "With warnings[a.bvh] Without warnings[b.bvh c.bvh]");
  EXPECT_EQ(grouped(Grouping::Preset), "Archive[b.bvh] none[a.bvh c.bvh]");
  EXPECT_EQ(grouped(Grouping::Worst), "2 cm to 5 cm[a.bvh b.bvh] not known[c.bvh]");
  EXPECT_EQ(grouped(Grouping::Length), "2 s to 5 s[a.bvh] not known[b.bvh c.bvh]");
}

TEST_F(ALibraryTree, FiltersByBoundsOnColumns) {
  LibraryEntry a = entry("/m/a.bvh", true), b = entry("/m/b.bvh", true), c = entry("/m/c.bvh");
  a.outcome->ratio = 120;
  b.outcome->ratio = 30;
  a.outcome->eps_cm = b.outcome->eps_cm = 0.6;
  clips_.setEntries({a, b, c});
  const auto filtered = [this](const char* words) {
    tree_.setFilter(QString::fromUtf8(words));
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(filtered("ratio<50"), "b.bvh");
  EXPECT_EQ(filtered("Error > 0,5"), "a.bvh b.bvh");
  EXPECT_EQ(filtered("a.b error>0.5 ratio>50"), "a.bvh");
  EXPECT_EQ(filtered("error>0.7"), "");
  EXPECT_EQ(filtered("ratio>3 ratio>31"), "a.bvh");
  EXPECT_EQ(filtered("length<9"), "") << "not known";
  EXPECT_EQ(filtered("error>"), "a.bvh b.bvh c.bvh") << "while it is typed";
  EXPECT_EQ(filtered("error>="), "a.bvh b.bvh c.bvh");
  EXPECT_EQ(filtered("ratio>=120"), "a.bvh");
  EXPECT_EQ(filtered("ratio ≤ 30"), "b.bvh");
  EXPECT_EQ(filtered("ratio<30"), "");
}

TEST_F(ALibraryTree, FiltersByWordsOfLoopAndPreset) {
  LibraryEntry a = entry("/m/a.bvh"), b = entry("/m/b.bvh");
  a.loop = Loop::Follows;
  b.preset = QStringLiteral("Archive");
  clips_.setEntries({a, b});
  tree_.setFilter(QStringLiteral("loop"));
  EXPECT_EQ(textOf(tree_).toStdString(), "a.bvh");
  tree_.setFilter(QStringLiteral("archive"));
  EXPECT_EQ(textOf(tree_).toStdString(), "b.bvh");
}

TEST_F(ALibraryTree, TakesUnitsInBounds) {
  LibraryEntry a = entry("/m/walk.bvh", true), b = entry("/m/b.bvh", true);
  a.outcome->eps_cm = 0.2;
  b.outcome->eps_cm = 0.6;
  a.outcome->motion_bytes = 900;
  b.outcome->motion_bytes = 2500;
  clips_.setEntries({a, b});
  const auto filtered = [this](const char* words) {
    tree_.setFilter(QString::fromUtf8(words));
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(filtered("error>0.5cm"), "b.bvh");
  EXPECT_EQ(filtered("error < 3 mm"), "walk.bvh");
  EXPECT_EQ(filtered("error<1M walk"), "walk.bvh");
  EXPECT_EQ(filtered("error<1 walk"), "walk.bvh") << "a word, no unit";
  EXPECT_EQ(filtered("bytes>1,000"), "b.bvh") << "as the column shows it";
  EXPECT_EQ(filtered("bytes>=2.5 kB"), "b.bvh");
  EXPECT_EQ(filtered("error>0.5furlongs"), "") << "words that no clip has";
}

TEST_F(ALibraryTree, TakesBoundsOnColumnsWithTitlesOfTwoWords) {
  LibraryEntry a = entry("/m/walk.bvh", true), b = entry("/m/b.bvh", true);
  for (LibraryEntry* clip : {&a, &b}) {
    const ClipFigures before{.done = true, .bytes = 1000};
    ClipFigures after = before;
    after.bytes = clip == &a ? 1100 : 900;
    clip->since = ClipDifference{.before = before, .after = after};
  }
  clips_.setEntries({a, b});
  const auto filtered = [this](const char* words) {
    tree_.setFilter(QString::fromUtf8(words));
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(filtered("bytes since>=10%"), "walk.bvh");
  EXPECT_EQ(filtered("b.b Bytes since < 5"), "b.bvh");
  EXPECT_EQ(filtered("bytes since<-10"), "");
}

TEST_F(ALibraryTree, TellsOnceOfChangesToTheClipsOfAFolder) {
  std::map<int, LibraryEntry> changed;
  for (int row = 0; row < clips_.rowCount(); ++row) {
    changed.emplace(row, clips_.entry(row));
    changed[row].frames = 20;
  }
  const QSignalSpy told(&tree_, &LibraryTree::dataChanged);
  clips_.replace(changed);
  EXPECT_EQ(told.count(), 6) << "the clips of three folders, and the folders";
}

TEST_F(ALibraryTree, ShowsClipsOfOneKind) {
  LibraryEntry seen = entry("/m/seen.bvh", true);
  seen.outcome->sight = Sight::Borderline;
  LibraryEntry noted = entry("/m/noted.bvh", true);
  noted.notes << QStringLiteral("guessed");
  LibraryEntry rejected = entry("/m/rejected.bvh", true);
  rejected.review.verdict = Verdict::Rejected;
  clips_.setEntries({seen, noted, rejected, entry("/m/missed.bvh", false), entry("/m/new.bvh")});
  const auto shown = [this](LibraryShow show) {
    tree_.setShow(show);
    return textOf(tree_).toStdString();
  };
  EXPECT_EQ(shown(LibraryShow::Visible), "seen.bvh");
  EXPECT_EQ(shown(LibraryShow::WithWarnings), "noted.bvh");
  EXPECT_EQ(shown(LibraryShow::Rejected), "rejected.bvh");
  EXPECT_EQ(shown(LibraryShow::Missed), "missed.bvh");
  EXPECT_EQ(shown(LibraryShow::Unfinished), "new.bvh");
  EXPECT_EQ(shown(LibraryShow::NotReviewed), "seen.bvh noted.bvh missed.bvh new.bvh");
  tree_.setFilter(QStringLiteral("new"));
  EXPECT_EQ(textOf(tree_).toStdString(), "new.bvh") << "both must match";
  EXPECT_EQ(shown(LibraryShow::Approved), "");
}

TEST_F(ALibraryTree, EveryColumnSaysWhatStandsInTheRow) {
  LibraryEntry full = entry("/m/walks/a.bvh", true);
  full.sample_rate_hz = 5;
  full.outcome->slide_cm = 1.5;
  full.outcome->sight = Sight::NotVisible;
  full.loop = Loop::Repeats;
  full.preset = QStringLiteral("Crowd");
  full.notes << QStringLiteral("guessed");
  full.review.verdict = Verdict::Approved;
  full.since = ClipDifference{.output = "a",
                              .before = ClipFigures{.done = true, .bytes = 500, .eps_cm = 0.2},
                              .after = ClipFigures{.done = true, .bytes = 1000, .eps_cm = 0.3},
                              .changes = {ClipChange::Larger}};
  clips_.setEntries({full});
  for (int column = 0; column < kLibraryColumns; ++column) {
    const QModelIndex index = tree_.indexOf(0).siblingAtColumn(column);
    EXPECT_FALSE(index.data().toString().isEmpty()) << column;
    EXPECT_FALSE(tree_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty());
    EXPECT_FALSE(tree_.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
  }
  const auto text = [&](LibraryColumn column) {
    return tree_.indexOf(0)
        .siblingAtColumn(static_cast<int>(column))
        .data()
        .toString()
        .toStdString();
  };
  EXPECT_EQ(text(LibraryColumn::Length), "2.00 s");
  EXPECT_EQ(text(LibraryColumn::Slide), "1.50 cm");
  EXPECT_EQ(text(LibraryColumn::Bytes), "1,000");
  EXPECT_EQ(text(LibraryColumn::BytesSince), "+100.0 %");
  EXPECT_EQ(text(LibraryColumn::Since), "larger");
}

TEST_F(ALibraryTree, ThePanelsColumnsAreChosenAndComeBack) {
  LibraryPanel panel(&clips_);
  const int bytes = static_cast<int>(LibraryColumn::Bytes);
  EXPECT_TRUE(panel.view()->isColumnHidden(bytes));
  QSignalSpy changed(&panel, &LibraryPanel::arrangementChanged);
  panel.makeColumnMenu()->actions().at(bytes - 1)->trigger();
  EXPECT_FALSE(panel.view()->isColumnHidden(bytes));
  panel.view()->sortByColumn(bytes, Qt::DescendingOrder);
  panel.groupingBox()->setCurrentIndex(static_cast<int>(Grouping::None));
  EXPECT_GE(changed.count(), 3);
  LibraryPanel next(&clips_);
  next.arrange(panel.arrangement());
  EXPECT_FALSE(next.view()->isColumnHidden(bytes));
  EXPECT_TRUE(next.view()->isColumnHidden(bytes + 1));
  EXPECT_EQ(textOf(*next.tree()), textOf(*panel.tree()));
  next.arrange("nonsense");
  EXPECT_FALSE(next.view()->isColumnHidden(bytes));
}

TEST_F(ALibraryTree, ThePanelSortsByColumnsThatAreNotShown) {
  LibraryEntry large = entry("/m/walks/a.bvh", true);
  large.outcome->motion_bytes = 5000;
  clips_.setEntry(large);
  LibraryPanel panel(&clips_);
  panel.groupingBox()->setCurrentIndex(static_cast<int>(Grouping::None));
  const QString before = textOf(*panel.tree());
  const auto sort_by = [&panel](int column) {
    const QList<QAction*> orders = panel.makeColumnMenu()->actions().last()->menu()->actions();
    orders.at(column + 1)->trigger();
  };
  const int bytes = static_cast<int>(LibraryColumn::Bytes);
  sort_by(bytes);
  EXPECT_TRUE(textOf(*panel.tree()).startsWith(QStringLiteral("a.bvh")));
  sort_by(bytes);
  EXPECT_TRUE(textOf(*panel.tree()).endsWith(QStringLiteral("a.bvh")));
  EXPECT_TRUE(panel.view()->isColumnHidden(bytes));
  sort_by(-1);
  EXPECT_EQ(textOf(*panel.tree()), before);
}

TEST_F(ALibraryTree, AChosenColumnHasRoomBesideTheClips) {
  LibraryPanel panel(&clips_);
  const int narrow = panel.minimumSizeHint().width();
  const int bytes = static_cast<int>(LibraryColumn::Bytes);
  panel.makeColumnMenu()->actions().at(bytes - 1)->trigger();
  EXPECT_GE(panel.minimumSizeHint().width(), narrow + panel.view()->columnWidth(bytes));
}

TEST_F(ALibraryTree, ThePanelKeepsTheSelectionWhereRowsMove) {
  LibraryPanel panel(&clips_);
  panel.setCurrent(0);
  panel.view()->selectionModel()->setCurrentIndex(panel.tree()->indexOf(3),
                                                  QItemSelectionModel::Select);
  panel.view()->sortByColumn(static_cast<int>(LibraryColumn::Clip), Qt::DescendingOrder);
  panel.groupingBox()->setCurrentIndex(static_cast<int>(Grouping::None));
  std::vector<int> chosen = panel.chosenRows();
  std::sort(chosen.begin(), chosen.end());
  EXPECT_EQ(chosen, (std::vector<int>{0, 3}));
  clips_.setEntry(entry("/m/walks/fast/b.bvh", true));
  EXPECT_EQ(panel.chosenRows().size(), 2u);
}

TEST_F(ALibraryTree, ThePanelShowsTheTotalSizeOfTheSelectionNowAndBefore) {
  LibraryEntry a = entry("/m/a.bvh", true), b = entry("/m/b.bvh", true);
  clips_.setEntries({a, b});
  LibraryPanel panel(&clips_);
  panel.view()->selectAll();
  EXPECT_EQ(panel.sum()->text().toStdString(), "2 clip(s): 2,000 bytes");
  a.bytes_before = 1000;
  a.outdated = Staleness::Settings;
  clips_.setEntry(a);
  EXPECT_EQ(panel.sum()->text().toStdString(),
            "2 clip(s): 2,000 bytes before, 1 not compressed yet");
  a.outdated = Staleness::None;
  a.outcome->motion_bytes = 400;
  clips_.setEntry(a);
  EXPECT_EQ(panel.sum()->text().toStdString(), "2 clip(s): 1,400 bytes, 2,000 before");
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
