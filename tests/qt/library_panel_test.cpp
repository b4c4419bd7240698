// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/library_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <QWhatsThis>

#include "widgets/models/library_model.h"
#include "widgets/models/library_tree.h"

namespace mocapress {
namespace {

TEST(LibraryModel, SaysInWordsWhatItsPicturesShow) {
  LibraryModel model;
  LibraryEntry entry{.path = QStringLiteral("/a/walk.bvh")};
  model.setEntry(entry);
  entry.frames = 120;
  entry.outcome = Outcome{25, 0.5, 2, 1000, false};
  model.setEntry(entry);
  ASSERT_EQ(model.rowCount(), 1);
  const QString words = model.index(0, 0).data(Qt::AccessibleTextRole).toString();
  EXPECT_TRUE(words.contains(QStringLiteral("walk.bvh")));
  EXPECT_TRUE(words.contains(QStringLiteral("25.0 : 1, 5.0 mm")));
  EXPECT_TRUE(words.contains(QStringLiteral("target missed")));
  entry.trouble = QStringLiteral("line 3: nonsense");
  model.setEntry(entry);
  EXPECT_TRUE(
      model.index(0, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("nonsense")));
}

TEST(LibraryModel, FindsClipsByTheirKeysAsRowsComeGoAndGetTakes) {
  LibraryModel model;
  const auto at = [](const char* path) { return LibraryEntry{.path = QString::fromLatin1(path)}; };
  model.setEntry(at("/a.fbx"));
  model.setEntry(at("/c.fbx"));
  EXPECT_EQ(model.rowOf(QStringLiteral("/c.fbx")), 1);
  model.insert(1, {at("/b.fbx")});
  EXPECT_EQ(model.rowOf(QStringLiteral("/b.fbx")), 1);
  EXPECT_EQ(model.rowOf(QStringLiteral("/c.fbx")), 2);
  LibraryEntry run = at("/a.fbx");
  run.take = "Run";
  model.replace({{0, run}});
  EXPECT_EQ(model.rowOf(QStringLiteral("/a.fbx")), -1);
  EXPECT_EQ(model.rowOf(run.key()), 0);
  model.setEntries({at("/c.fbx")});
  EXPECT_EQ(model.rowOf(QStringLiteral("/c.fbx")), 0);
  EXPECT_EQ(model.rowOf(run.key()), -1);
}

TEST(LibraryModel, SaysWhyAVerdictIsStaleWhoGaveItAndWhen) {
  LibraryModel model;
  LibraryEntry entry{.path = QStringLiteral("/a/walk.bvh")};
  entry.outcome = Outcome{25, 0.5, 2, 1000, true, Sight::Borderline};
  entry.review = {Verdict::Approved, "fine", "ann", "2026-11-27T01:39:46Z", "1", "2"};
  const auto words = [&] {
    model.setEntry(entry);
    return model.index(0, 0).data(Qt::AccessibleTextRole).toString();
  };
  EXPECT_TRUE(words().contains(QStringLiteral("5.0 mm, ✓ approved, borderline from 5 m")));
  EXPECT_EQ(stateOf(entry), RowState::Good);
  entry.stale = Staleness::Source;
  EXPECT_TRUE(words().contains(QStringLiteral("✓ stale: file changed")));
  EXPECT_EQ(stateOf(entry), RowState::Doubtful);
  entry.missing = true;
  entry.stale = Staleness::Missing;
  EXPECT_TRUE(words().contains(QStringLiteral("✓ stale: file missing")));
  EXPECT_EQ(stateOf(entry), RowState::Bad);
  EXPECT_TRUE(model.index(0, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("ann, ")));
}

TEST(LibraryModel, ANarrowListKeepsWhatIsSeenBeforeATargetThatIsMet) {
  LibraryEntry entry{.path = QStringLiteral("/a/walk.bvh"), .frames = 9};
  entry.outcome = Outcome{25, 0.5, 2, 1000, true, Sight::Visible};
  EXPECT_EQ(stateText(entry), QStringLiteral("visible from 5 m, target met"));
  entry.outcome->met = false;
  EXPECT_EQ(stateText(entry), QStringLiteral("! target missed, visible from 5 m"));
}

TEST(LibraryModel, NotesOnReadingAreBehindAMarkOfTheRow) {
  LibraryModel model;
  LibraryEntry entry{.path = QStringLiteral("/a/walk.bvh"), .frames = 9};
  entry.outcome = Outcome{.warnings = {QStringLiteral("of the outcome")}};
  EXPECT_EQ(notesOf(entry), QStringList(QStringLiteral("of the outcome")));
  entry.notes = {QStringLiteral("guessed"), QStringLiteral("repaired")};
  EXPECT_EQ(notesOf(entry), entry.notes + entry.outcome->warnings);
  entry.outdated = Staleness::Source;
  EXPECT_EQ(notesOf(entry), entry.notes) << "the file changed since it was compressed";
  model.setEntry(entry);
  EXPECT_TRUE(model.index(0, 0)
                  .data(Qt::ToolTipRole)
                  .toString()
                  .endsWith(QStringLiteral("guessed\nrepaired")));
  EXPECT_TRUE(
      model.index(0, 0).data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("2 note")));
}

TEST(LibraryPanel, AClickOnTheMarkOfARowTellsItsNotes) {
  LibraryModel model;
  model.setEntries(
      {{.path = QStringLiteral("a"), .frames = 9, .notes = {QStringLiteral("guessed")}},
       {.path = QStringLiteral("b"), .frames = 9}});
  LibraryPanel panel(&model);
  panel.resize(240, 400);
  panel.show();
  const auto ends = [&](int row) {
    const QRect place = panel.view()->visualRect(panel.tree()->indexOf(row));
    return QPoint(place.right() - 12, place.top() + 12);
  };
  const QImage list = panel.view()->viewport()->grab().toImage();
  const auto ink = [&](int row) {
    QSet<QRgb> colours;
    for (int x = -6; x < 6; ++x) colours.insert(list.pixel(ends(row) + QPoint(x, 0)));
    return colours.size();
  };
  EXPECT_GT(ink(0), 1);
  EXPECT_EQ(ink(1), 1) << "nothing was guessed";
  const auto told = [] {
    const QWidgetList windows = QApplication::topLevelWidgets();
    return std::any_of(windows.begin(), windows.end(), [](const QWidget* window) {
      return window->inherits("QWhatsThat") && window->isVisible();
    });
  };
  QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, ends(1));
  EXPECT_FALSE(told());
  QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, ends(0));
  EXPECT_TRUE(told());
  QWhatsThis::hideText();
}

TEST(LibraryPanel, TheMenuGivesTheSelectionAVerdictOrAPresetAndFindsWhatIsMissing) {
  LibraryModel model;
  model.setEntries({{.path = QStringLiteral("a")}, {.path = QStringLiteral("b")}});
  LibraryPanel panel(&model);
  panel.setPresets({built_in_presets()[0]});
  panel.view()->selectAll();
  QSignalSpy verdict(&panel, &LibraryPanel::verdictChosen);
  QSignalSpy preset(&panel, &LibraryPanel::presetChosen);
  QSignalSpy find(&panel, &LibraryPanel::findMissingRequested);
  QMenu* menu = panel.makeMenu();
  const auto menus = menu->findChildren<QMenu*>();
  ASSERT_EQ(menus.size(), 2);
  menus[0]->actions().at(1)->trigger();
  ASSERT_EQ(verdict.count(), 1);
  EXPECT_EQ(verdict[0][0].value<std::vector<int>>(), (std::vector<int>{0, 1}));
  menus[1]->actions().at(0)->trigger();
  EXPECT_EQ(preset.count(), 1);
  EXPECT_FALSE(menu->actions().back()->isEnabled()) << "nothing is missing";
  LibraryEntry gone = model.entry(1);
  gone.missing = true;
  model.setEntry(gone);
  panel.makeMenu()->actions().back()->trigger();
  EXPECT_EQ(find.count(), 1);
}

TEST(LibraryPanel, ShowsTheReviewOfTheCurrentClipAndTellsOfChanges) {
  LibraryModel model;
  model.setEntries({{.path = QStringLiteral("a")},
                    {.path = QStringLiteral("b"), .review = {Verdict::Approved, "fine"}}});
  LibraryPanel panel(&model);
  QSignalSpy opened(&panel, &LibraryPanel::openRequested);
  panel.setCurrent(1);
  EXPECT_EQ(panel.note()->text(), QStringLiteral("fine"));
  EXPECT_EQ(panel.verdict()->currentData().toInt(), static_cast<int>(Verdict::Approved));
  EXPECT_EQ(opened.count(), 0);
  panel.view()->setCurrentIndex(panel.tree()->indexOf(0));
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(opened[0][0].toInt(), 0);
  QSignalSpy noted(&panel, &LibraryPanel::noteEdited);
  QTest::keyClicks(panel.note(), QStringLiteral("x"));
  ASSERT_EQ(noted.count(), 1);
  EXPECT_EQ(noted[0][1].toString(), QStringLiteral("x"));
}

}  // namespace
}  // namespace mocapress
