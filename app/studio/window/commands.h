// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <vector>

class QAction;
class QMenuBar;

namespace mocapress {

/// A command of the window's menus.
struct Command {
  QAction* action = nullptr;
  QString menus;       // the menus it is in, such as "View › Cameras"
  QKeySequence usual;  // its key before the user changed it
};

/// All commands of the menus, in their order. Menus that are filled when they open are left out.
std::vector<Command> commandsOf(const QMenuBar& menus);

/// Name of a property: the constant name of an action whose text changes, such as one that names
/// the step to undo.
inline constexpr const char* kLastingName = "name";  // property of its action

/// The name of a command in lists of keys.
QString nameOf(const QAction& action);

/// A text of a menu or action without the & before its shortcut letter and without dots.
QString plainText(QString text);

/// Sets the key of a command, and names it in the tool tip if that named the former key.
void setKey(QAction* action, const QKeySequence& key);

/// Gives commands the keys that the user chose in earlier runs. Commands are known by objectName(),
/// which no language changes; those without one keep their keys.
void restoreKeys(const std::vector<Command>& commands);

/// Sets a key and remembers it, unless it is the usual one.
void chooseKey(const Command& command, const QKeySequence& key);

/// The other command that has the key; null: none.
const Command* holderOf(const QKeySequence& key, const std::vector<Command>& commands,
                        const QAction* except);

}  // namespace mocapress
