// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that the user chooses, and commands found by their words.
#include "app/studio/window/commands.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSet>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include "app/studio/window/command_palette.h"
#include "app/studio/window/keyboard_map.h"
#include "app/studio/window/main_window.h"
#include "tests/qt/patience.h"

namespace mocapress {
namespace {

class Commands : public testing::Test {
 protected:
  Commands() {
    QSettings().clear();
    QMenu* view = menus_.addMenu(QStringLiteral("&View"));
    near_ = add(view, QStringLiteral("Go &Near…"), Qt::Key_N, QStringLiteral("near"));
    QMenu* cameras = view->addMenu(QStringLiteral("&Cameras"));
    far_ = add(cameras, QStringLiteral("Go &Far"), Qt::Key_F, QStringLiteral("far"));
    plain_ = add(cameras, QStringLiteral("Turn"), {}, QString());
    far_->setToolTip(QStringLiteral("Go away (F)"));
    commands_ = commandsOf(menus_);
  }
  ~Commands() override { QSettings().clear(); }

  static QAction* add(QMenu* menu, const QString& text, const QKeySequence& key,
                      const QString& name) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    action->setObjectName(name);
    return action;
  }

  QMenuBar menus_;
  QAction* near_ = nullptr;
  QAction* far_ = nullptr;
  QAction* plain_ = nullptr;
  std::vector<Command> commands_;
};

TEST_F(Commands, KeepTheirNamesInListsOfKeysWhateverTheyAreAboutToDo) {
  EXPECT_EQ(nameOf(*near_), QStringLiteral("Go Near"));
  near_->setProperty(kLastingName, QStringLiteral("Go &Near…"));
  near_->setText(QStringLiteral("Go &Near the Left Hand"));
  EXPECT_EQ(nameOf(*near_), QStringLiteral("Go Near"));
  KeyboardMap map(commands_, nullptr);
  EXPECT_EQ(map.findChild<QTreeWidget*>()->topLevelItem(0)->text(0), QStringLiteral("Go Near"));
}

TEST_F(Commands, AreThoseOfAllMenusInTheirOrder) {
  ASSERT_EQ(commands_.size(), 3u);
  EXPECT_EQ(commands_[0].action, near_);
  EXPECT_EQ(commands_[1].action, far_);
  EXPECT_EQ(commands_[1].menus, QStringLiteral("View › Cameras"));
}

TEST_F(Commands, KeepTheKeysThatTheUserChose) {
  chooseKey(commands_[1], Qt::CTRL | Qt::Key_G);
  EXPECT_EQ(far_->toolTip(), QStringLiteral("Go away (Ctrl+G)"));
  far_->setShortcut(Qt::Key_F);  // as in the next run
  restoreKeys(commands_);
  EXPECT_EQ(far_->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_G));
  chooseKey(commands_[1], Qt::Key_F);
  far_->setShortcut(Qt::Key_F);
  restoreKeys(commands_);
  EXPECT_EQ(far_->shortcut(), QKeySequence(Qt::Key_F));
}

TEST_F(Commands, CanBeWithoutAKey) {
  chooseKey(commands_[0], {});
  near_->setShortcut(Qt::Key_N);
  restoreKeys(commands_);
  EXPECT_TRUE(near_->shortcut().isEmpty());
}

TEST_F(Commands, AreFoundByWordsOfNameAndMenu) {
  CommandPalette palette(commands_, nullptr);
  EXPECT_EQ(palette.found().size(), 3);
  palette.words()->setText(QStringLiteral("go"));
  EXPECT_EQ(palette.found(), QStringList({QStringLiteral("Go Near"), QStringLiteral("Go Far")}));
  palette.words()->setText(QStringLiteral("camera go"));
  EXPECT_EQ(palette.found(), QStringList(QStringLiteral("Go Far")));
  const auto* none = palette.findChild<QLabel*>();
  EXPECT_FALSE(none->isVisibleTo(&palette));
  palette.words()->setText(QStringLiteral("nothing"));
  EXPECT_TRUE(palette.found().isEmpty());
  EXPECT_TRUE(none->isVisibleTo(&palette));
}

TEST_F(Commands, RunWithEnter) {
  int runs = 0;
  QObject::connect(far_, &QAction::triggered, [&] { ++runs; });
  auto* palette = new CommandPalette(commands_, nullptr);
  palette->show();
  palette->words()->setText(QStringLiteral("go"));
  near_->setEnabled(false);
  palette->words()->setText(QStringLiteral("go "));
  QTest::keyClick(palette->words(), Qt::Key_Return);
  runDueEvents();
  EXPECT_EQ(runs, 1);  // the first that can be run
}

TEST_F(Commands, TakeAKeyFromAnotherAfterItWasSaid) {
  KeyboardMap map(commands_, nullptr);
  auto* list = map.findChild<QTreeWidget*>();
  ASSERT_EQ(list->topLevelItemCount(), 2);  // the one without a name keeps its key
  list->setCurrentItem(list->topLevelItem(0));
  auto* key = map.findChild<QKeySequenceEdit*>();
  key->setKeySequence(Qt::Key_F);
  QString said;
  for (const QLabel* label : map.findChildren<QLabel*>()) said += label->text();
  EXPECT_TRUE(said.contains(QStringLiteral("Go Far"))) << qPrintable(said);
  for (QPushButton* button : map.findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Assign")) button->click();
  EXPECT_EQ(near_->shortcut(), QKeySequence(Qt::Key_F));
  EXPECT_TRUE(far_->shortcut().isEmpty());
  for (QPushButton* button : map.findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Usual Keys for All")) button->click();
  EXPECT_EQ(near_->shortcut(), QKeySequence(Qt::Key_N));
  EXPECT_EQ(far_->shortcut(), QKeySequence(Qt::Key_F));
}

TEST(CommandsOfTheWindow, HaveNamesAndKeysOfTheirOwn) {
  QSettings().clear();
  const MainWindow window;
  QSet<QString> names;
  QMap<QString, QString> keys;
  for (const Command& command : window.commands()) {
    const QString text = command.action->text();
    const QString name = command.action->objectName();
    if (command.usual.isEmpty() && name.isEmpty()) continue;  // a choice within a menu
    EXPECT_FALSE(name.isEmpty()) << qPrintable(text);
    EXPECT_FALSE(names.contains(name)) << qPrintable(name);
    names << name;
    if (command.usual.isEmpty()) continue;
    EXPECT_FALSE(keys.contains(command.usual.toString()))
        << qPrintable(text + QStringLiteral(" and ") + keys[command.usual.toString()]);
    keys[command.usual.toString()] = text;
  }
  EXPECT_GT(names.size(), 80);
}

}  // namespace
}  // namespace mocapress
