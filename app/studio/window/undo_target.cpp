// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/undo_target.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>

#include "app/studio/document/edit_step.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"

namespace mocapress {
namespace {

/// True for menu and tool bars: users only pass through them on their way back.
bool isPassedThrough(const QWidget* widget) {
  return qobject_cast<const QMenuBar*>(widget) ||
         qobject_cast<const QToolBar*>(widget->parentWidget());
}

/// True if `top` is a detached dock of the window.
bool isDockOf(const QWidget* window, const QWidget* top) {
  return qobject_cast<const QDockWidget*>(top) && top->parentWidget() == window;
}

}  // namespace

UndoTarget::UndoTarget(Session* session, Library* library, QWidget* window)
    : QObject(window), session_(session), library_(library), window_(window) {
  add(library->history());
  takeClip();
  histories_.setActiveStack(session->history());
  connect(session, &Session::historyChanged, this, &UndoTarget::takeClip);
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget*, const QWidget* now) { follow(now); });
}

/// A clip without steps leaves the library current; a clip with steps becomes current, since a user
/// who returns to it wants to undo those.
void UndoTarget::takeClip() {
  QUndoStack* history = session_->history();
  if (!histories_.stacks().contains(history)) add(history);
  if (history->canUndo() || histories_.activeStack() != library_->history())
    histories_.setActiveStack(history);
}

/// Renames the steps, since a window in another language may have made them. From now on, a new
/// step makes its history current: a shortcut may change a clip while the library has the focus.
void UndoTarget::add(QUndoStack* history) {
  renameSteps(*history);
  histories_.addStack(history);
  connect(history, &QUndoStack::indexChanged, this, [this, history](int index) {
    const bool is_current = history == library_->history() || history == session_->history();
    if (index > 0 && is_current) histories_.setActiveStack(history);
  });
}

void UndoTarget::follow(const QWidget* focus) {
  if (!focus || !panel_ || isPassedThrough(focus)) return;
  if (focus == panel_ || panel_->isAncestorOf(focus))
    histories_.setActiveStack(library_->history());
  else if (focus->window() == window_ || isDockOf(window_, focus->window()))
    histories_.setActiveStack(session_->history());
}

}  // namespace mocapress
