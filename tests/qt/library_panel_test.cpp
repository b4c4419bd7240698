// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/library_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

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
  const QString words = model.index(0).data(Qt::AccessibleTextRole).toString();
  EXPECT_TRUE(words.contains(QStringLiteral("walk.bvh")));
  EXPECT_TRUE(words.contains(QStringLiteral("25.0 : 1, 5.0 mm")));
  EXPECT_TRUE(words.contains(QStringLiteral("target missed")));
  entry.trouble = QStringLiteral("line 3: nonsense");
  model.setEntry(entry);
  EXPECT_TRUE(model.index(0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("nonsense")));
}

TEST(LibraryPanel, ShowsTheReviewOfTheCurrentClipAndTellsOfChanges) {
  LibraryModel model;
  model.setEntries({{.path = QStringLiteral("a")},
                    {.path = QStringLiteral("b"),
                     .verdict = Verdict::Approved,
                     .note = QStringLiteral("fine")}});
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
