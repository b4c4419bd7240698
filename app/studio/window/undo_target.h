// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoGroup>

class QWidget;

namespace mocapress {

class Library;
class Session;

/// Decides if Edit > Undo acts on the library or on the open clip: on the one that last had the
/// focus, had a step, or was opened with steps. When its steps are used up, Undo does not go on
/// with the other's.
class UndoTarget : public QObject {
  Q_OBJECT

 public:
  UndoTarget(Session* session, Library* library, QWidget* window);

  QUndoGroup* histories() { return &histories_; }

  /// Focus in this panel means that the user works in the library.
  void setLibraryPanel(const QWidget* panel) { panel_ = panel; }

 private:
  void takeClip();
  void follow(const QWidget* focus);
  void add(QUndoStack* history);

  Session* session_;
  Library* library_;
  QWidget* window_;
  const QWidget* panel_ = nullptr;
  QUndoGroup histories_;
};

}  // namespace mocapress
