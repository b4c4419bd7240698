// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/studio/window/commands.h"

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace mocapress {

/// Finds a command by words of its name or its menus, and runs it with Enter. The arrow keys choose
/// among those found while the field keeps the focus.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  CommandPalette(std::vector<Command> commands, QWidget* parent);

  QLineEdit* words() const { return words_; }

  /// Texts of the commands that are found, best first.
  QStringList found() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find(const QString& words);
  void run(const QTreeWidgetItem* item);

  std::vector<Command> commands_;
  QLineEdit* words_;
  QLabel* none_;  // shown while nothing is found
  QTreeWidget* list_;
};

}  // namespace mocapress
