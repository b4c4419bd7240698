// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QToolButton;

namespace mocapress {

/// Chooses the mesh file of a character to put on every clip that it fits, or no file.
class CharacterChoice : public QWidget {
  Q_OBJECT

 public:
  explicit CharacterChoice(QWidget* parent = nullptr);

  /// An empty path means none. Emits nothing.
  void setPath(const QString& path);

  QPushButton* file() const { return file_; }
  QToolButton* removal() const { return remove_; }

 signals:
  void fileRequested();
  void removed();

 private:
  QPushButton* file_;
  QToolButton* remove_;
};

}  // namespace mocapress
