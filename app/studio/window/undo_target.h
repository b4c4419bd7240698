// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoGroup>

class QWidget;

namespace mocapress {

class Library;
class Session;

/// What Edit > Undo acts on: the history of the library, or that of the clip that is open,
/// whichever the user worked in last. That is where the focus went last, or where a step was done
/// since, or a clip with steps that was opened since. When these are used up, nothing else is
/// undone instead.
class UndoTarget : public QObject {
  Q_OBJECT

 public:
  UndoTarget(Session* session, Library* library, QWidget* window);

  QUndoGroup* histories() { return &histories_; }

  /// While the focus is in this panel, it is the library that is worked in.
  void setLibraryPanel(const QWidget* panel) { panel_ = panel; }

 private:
  void takeClip();
  void follow(const QWidget* focus);
  void followSteps(QUndoStack* history);

  Session* session_;
  Library* library_;
  QWidget* window_;
  const QWidget* panel_ = nullptr;
  QUndoGroup histories_;
};

}  // namespace mocapress
