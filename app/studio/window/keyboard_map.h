// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/studio/window/commands.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace mocapress {

/// Lists all commands with their keys and changes them. A key that is given to a second command is
/// taken from the first, after a warning. Changes apply at once and are remembered.
class KeyboardMap : public QDialog {
  Q_OBJECT

 public:
  KeyboardMap(std::vector<Command> commands, QWidget* parent);

 private:
  const Command* chosen() const;  // null: none
  void fill();
  void find(const QString& words);
  void showChosen();
  void showConflict();
  void assign(const QKeySequence& key);
  void resetAll();

  std::vector<Command> commands_;
  QLineEdit* words_;
  QTreeWidget* list_;
  QKeySequenceEdit* key_;
  QPushButton* assign_;
  QPushButton* clear_;
  QPushButton* usual_;
  QLabel* conflict_;
};

}  // namespace mocapress
