// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/commands.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>

namespace mocapress {
namespace {

QString settingOf(const QAction& action) {
  return QStringLiteral("keys/") + action.objectName();
}

void collect(const QMenu& menu, const QString& menus, std::vector<Command>& commands) {
  for (QAction* action : menu.actions()) {
    if (action->isSeparator() || action->text().isEmpty()) continue;
    if (const QMenu* below = action->menu())
      collect(*below, menus + QStringLiteral(" › ") + plainText(action->text()), commands);
    else
      commands.push_back({action, menus, action->shortcut()});
  }
}

/// The end of a tool tip, which shows the key.
QString ending(const QKeySequence& key) {
  return key.isEmpty() ? QString()
                       : QStringLiteral(" (%1)").arg(key.toString(QKeySequence::NativeText));
}

}  // namespace

QString plainText(QString text) {
  // Japanese texts have the shortcut letter in parentheses at the end.
  static const QRegularExpression letter(QStringLiteral(R"(\(&.\)|&|…)"));
  return text.remove(letter);
}

QString nameOf(const QAction& action) {
  const QVariant name = action.property(kLastingName);
  return plainText(name.isValid() ? name.toString() : action.text());
}

std::vector<Command> commandsOf(const QMenuBar& menus) {
  std::vector<Command> commands;
  for (const QAction* top : menus.actions())
    if (top->menu()) collect(*top->menu(), plainText(top->text()), commands);
  return commands;
}

void setKey(QAction* action, const QKeySequence& key) {
  const QString before = ending(action->shortcut());
  QString tip = action->toolTip();
  const bool names_key = !before.isEmpty() && tip.endsWith(before);
  action->setShortcut(key);
  if (!names_key) return;
  tip.chop(before.size());
  action->setToolTip(tip + ending(key));
}

void restoreKeys(const std::vector<Command>& commands) {
  const QSettings settings;
  for (const Command& command : commands) {
    const QString setting = settingOf(*command.action);
    if (!command.action->objectName().isEmpty() && settings.contains(setting))
      setKey(command.action, QKeySequence(settings.value(setting).toString()));
  }
}

void chooseKey(const Command& command, const QKeySequence& key) {
  setKey(command.action, key);
  QSettings settings;
  if (key == command.usual)
    settings.remove(settingOf(*command.action));
  else
    settings.setValue(settingOf(*command.action), key.toString());
}

const Command* holderOf(const QKeySequence& key, const std::vector<Command>& commands,
                        const QAction* except) {
  if (key.isEmpty()) return nullptr;
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const Command& command) {
    return command.action != except && command.action->shortcut() == key;
  });
  return found == commands.end() ? nullptr : &*found;
}

}  // namespace mocapress
