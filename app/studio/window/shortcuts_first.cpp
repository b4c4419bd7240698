// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/shortcuts_first.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>
#include <array>

namespace mocapress {
namespace {

bool isOneOf(const QKeyEvent& key, std::initializer_list<QKeySequence::StandardKey> keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&key](QKeySequence::StandardKey standard) { return key.matches(standard); });
}

/// On every desktop, unlike what X11 adds to them.
bool editsText(const QKeyEvent& key) {
  return isOneOf(key, {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste,
                       QKeySequence::SelectAll}) ||
         key.key() == Qt::Key_Left || key.key() == Qt::Key_Right || key.key() == Qt::Key_Home ||
         key.key() == Qt::Key_End || key.key() == Qt::Key_Backspace || key.key() == Qt::Key_Delete;
}

}  // namespace

/// Who ignores a ShortcutOverride gets the key all the same where there is no such shortcut.
bool ShortcutsFirst::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const bool is_number = qobject_cast<QAbstractSpinBox*>(watched);
  if (!is_number && !qobject_cast<QLineEdit*>(watched)) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const bool has_modifier = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
  const bool uses_rle = is_number && (key.key() == Qt::Key_Space ||
                                      (!key.text().isEmpty() && key.text()[0].isLetter()));
  const bool undoes_typing = !is_number && isOneOf(key, {QKeySequence::Undo, QKeySequence::Redo});
  const bool goes_to_shortcuts = uses_rle || (has_modifier && !editsText(key) && !undoes_typing);
  if (goes_to_shortcuts) event->ignore();
  return goes_to_shortcuts;
}

}  // namespace mocapress
