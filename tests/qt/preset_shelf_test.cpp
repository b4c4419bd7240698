// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/preset_shelf.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>

#include "core/base/file.h"
#include "core/mocapress/settings_json.h"

namespace mocapress {
namespace {

Settings mine() {
  return {.name = "Mine",
          .target = {Target::Kind::Ratio, 12},
          .effort = Effort::Best,
          .importance = {.factors = {{"feet", 4}, {"lwrist", 2}}, .contacts = 5},
          .correction = CorrectionSettings{.ratio = 16.0}};
}

class PresetShelfTest : public testing::Test {
 protected:
  QString path(const char* name) const { return directory_.filePath(QString::fromLatin1(name)); }
  std::size_t own() const { return shelf_.all().size() - built_in_presets().size(); }

  QTemporaryDir directory_;
  PresetShelf shelf_{directory_.filePath(QStringLiteral("settings/presets.json"))};
};

TEST_F(PresetShelfTest, KeepsOwnPresetsInAFileThatTheCommandLineTakes) {
  EXPECT_TRUE(shelf_.save(mine()));
  EXPECT_EQ(PresetShelf(path("settings/presets.json")).all().back(), mine());
  EXPECT_EQ(find_preset(path("settings/presets.json").toStdString()), mine());
}

TEST_F(PresetShelfTest, SharesThemAsFiles) {
  shelf_.exportTo(path("mine.json"), mine());
  EXPECT_EQ(find_preset(path("mine.json").toStdString()), mine());
  shelf_.importFrom(path("mine.json"));
  shelf_.importFrom(path("mine.json"));  // a second import replaces the first
  ASSERT_EQ(own(), 1u);
  EXPECT_EQ(shelf_.all().back(), mine());
  QSignalSpy noted(&shelf_, &PresetShelf::noted);
  write_text(path("broken.json").toStdString(), R"({"name": "x", "target": 3})");
  shelf_.importFrom(path("broken.json"));
  EXPECT_EQ(noted.count(), 1);
  EXPECT_EQ(own(), 1u);
}

TEST_F(PresetShelfTest, GivesNoNameTwice) {
  QSignalSpy noted(&shelf_, &PresetShelf::noted);
  EXPECT_FALSE(shelf_.save({.name = "Crowd"}));
  EXPECT_FALSE(shelf_.save({.name = "hero-close-up"}));  // the command line prefers its own
  shelf_.save(mine());
  shelf_.save({.name = "Other"});
  EXPECT_FALSE(shelf_.rename(QStringLiteral("Other"), QStringLiteral("Mine")));
  EXPECT_FALSE(shelf_.rename(QStringLiteral("Other"), QStringLiteral("Archive")));
  EXPECT_EQ(noted.count(), 4);
  EXPECT_EQ(own(), 2u);
}

TEST_F(PresetShelfTest, EveryChangeCanBeUndone) {
  QUndoStack history;
  shelf_.setHistory([&history] { return &history; });
  shelf_.save(mine());
  EXPECT_TRUE(shelf_.rename(QStringLiteral("Mine"), QStringLiteral("Ours")));
  EXPECT_EQ(shelf_.all().back().name, "Ours");
  shelf_.remove(QStringLiteral("Ours"));
  EXPECT_EQ(own(), 0u);
  history.undo();
  EXPECT_EQ(shelf_.all().back().name, "Ours");
  history.undo();
  EXPECT_EQ(shelf_.all().back(), mine());
  history.undo();
  EXPECT_EQ(own(), 0u);
  EXPECT_EQ(PresetShelf(path("settings/presets.json")).all().size(), built_in_presets().size());
  history.redo();
  EXPECT_EQ(shelf_.all().back(), mine());
}

TEST_F(PresetShelfTest, AFileThatCannotBeReadStaysAsItIs) {
  write_text(path("odd.json").toStdString(), "{ not JSON");
  EXPECT_EQ(PresetShelf(path("odd.json")).all().size(), built_in_presets().size());
  EXPECT_EQ(read_text(path("odd.json").toStdString()), "{ not JSON");
}

TEST_F(PresetShelfTest, SetsAnUnreadableFileAsideWhenAPresetIsSaved) {
  write_text(path("odd.json").toStdString(), "{ not JSON");
  PresetShelf shelf(path("odd.json"));
  QSignalSpy noted(&shelf, &PresetShelf::noted);
  shelf.save(mine());
  EXPECT_EQ(read_text(path("odd.json.unreadable").toStdString()), "{ not JSON");
  EXPECT_EQ(PresetShelf(path("odd.json")).all().back(), mine());
  ASSERT_EQ(noted.count(), 1);
  EXPECT_TRUE(noted[0][0].toString().contains(QStringLiteral("odd.json.unreadable")));
}

TEST_F(PresetShelfTest, UndoingLeavesAloneWhatWasChangedSince) {
  QUndoStack one;
  QUndoStack other;
  QUndoStack* current = &one;
  shelf_.setHistory([&current] { return current; });
  shelf_.save(mine());
  current = &other;
  Settings changed = mine();
  changed.target.value = 30;
  shelf_.save(changed);
  one.undo();
  EXPECT_EQ(shelf_.all().back(), changed);
}

}  // namespace
}  // namespace mocapress
