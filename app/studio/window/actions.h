// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "app/studio/window/view_actions.h"
#include "widgets/timeline/transport_bar.h"

class QAction;
class QActionGroup;
class QDockWidget;
class QMainWindow;
class QMenu;
class QUndoGroup;

namespace mocapress {

/// Everything the user can ask for by menu, tool bar or key.
struct Actions {
  QAction* open = nullptr;
  QAction* open_sample = nullptr;
  QAction* choose_skeleton = nullptr;  // the remedy for an .amc that was not read
  QAction* compare = nullptr;
  QAction* save = nullptr;
  QAction* save_as = nullptr;
  QAction* export_motion = nullptr;
  QAction* export_review = nullptr;  // not seen where the build has no viewer
  QAction* import_options = nullptr;
  QAction* put_character = nullptr;
  QAction* take_character_off = nullptr;
  QAction* batch = nullptr;
  QAction* export_library = nullptr;
  QAction* add_clips = nullptr;
  QAction* add_folder = nullptr;
  QAction* new_project = nullptr;
  QAction* open_project = nullptr;
  QAction* save_project = nullptr;
  QAction* quit = nullptr;
  QAction* switch_slot = nullptr;  // A/B
  QAction* copy_slot = nullptr;
  QAction* pin = nullptr;  // the current result
  QAction* undo = nullptr;
  QAction* redo = nullptr;
  QAction* next_worst = nullptr;
  QAction* previous_worst = nullptr;
  QAction* hold_feet = nullptr;
  QAction* without_ik = nullptr;  // A/B
  QAction* reset_layout = nullptr;
  QAction* study = nullptr;
  QAction* guide = nullptr;
  QAction* shortcuts = nullptr;
  QAction* about = nullptr;
  QActionGroup* themes = nullptr;        // by ThemeChoice
  QActionGroup* languages = nullptr;     // data(): its code, empty: the system's
  QActionGroup* error_scales = nullptr;  // of distances
  QActionGroup* angle_scales = nullptr;
  QAction* in_degrees = nullptr;  // errors of heat map and graph
  QAction* as_seen = nullptr;     // in the heat map
  ViewActions view;
  TransportActions transport;
};

/// With texts, icons and shortcuts; connecting is the window's part.
Actions makeActions(Playback* playback, QUndoGroup* history, QMainWindow* window);

/// Those that the window fills.
struct RecentMenus {
  QMenu* files = nullptr;
  QMenu* projects = nullptr;
};

/// Menus and tool bar.
RecentMenus addMenus(QMainWindow* window, const Actions& actions, const QList<QDockWidget*>& docks);

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
