// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace mocapress {

/// Leaves keys with Ctrl or Alt to the shortcuts of the program while a field has the focus: Qt's
/// line edits take some of them for themselves, such as Ctrl+E for the end of the line. What edits
/// text stays with them. A number has no text to edit: what is not part of it goes to shortcuts.
class ShortcutsFirst : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace mocapress
