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

/// All actions of menus, tool bar and keys.
struct Actions {
  QAction* open = nullptr;
  QAction* open_sample = nullptr;
  QAction* choose_skeleton = nullptr;  // offered when an .amc could not be read
  QAction* compare = nullptr;
  QAction* save = nullptr;
  QAction* save_as = nullptr;
  QAction* export_motion = nullptr;
  QAction* export_review = nullptr;  // hidden in a build without the viewer
  QAction* copy_picture = nullptr;   // copies the 3D view
  QAction* save_picture = nullptr;
  QAction* film = nullptr;       // the chosen range, or the clip
  QAction* turntable = nullptr;  // the frame that is shown, from all sides
  QAction* import_options = nullptr;
  QAction* put_character = nullptr;
  QAction* take_character_off = nullptr;
  QAction* batch = nullptr;
  QAction* export_library = nullptr;
  QAction* compare_batch = nullptr;
  QAction* export_sign_off = nullptr;
  QAction* add_clips = nullptr;
  QAction* add_folder = nullptr;
  QAction* new_project = nullptr;
  QAction* open_project = nullptr;
  QAction* save_project = nullptr;
  QAction* quit = nullptr;
  QAction* switch_slot = nullptr;  // switches between A and B
  QAction* copy_slot = nullptr;
  QAction* pin = nullptr;         // pins the current result
  QAction* pin_engine = nullptr;  // pins an engine's result with as many bytes
  QAction* undo = nullptr;
  QAction* redo = nullptr;
  QAction* next_review = nullptr;  // the next clip that waits for a verdict
  QAction* approve = nullptr;      // approves the clip and opens the next
  QAction* reject = nullptr;
  QAction* note_here = nullptr;
  QAction* note_on_range = nullptr;
  QAction* next_note = nullptr;
  QAction* write_notes = nullptr;  // writes notes to files beside the clips
  QAction* read_notes = nullptr;
  QAction* copy_link = nullptr;
  QAction* compare_range = nullptr;
  QAction* next_worst = nullptr;
  QAction* previous_worst = nullptr;
  QAction* hold_feet = nullptr;
  QAction* without_ik = nullptr;  // toggles the IK correction
  QAction* panels_below = nullptr;
  QAction* reset_layout = nullptr;
  QAction* study = nullptr;
  QAction* blind_test = nullptr;
  QAction* guide = nullptr;
  QAction* shortcuts = nullptr;
  QAction* find_command = nullptr;
  QAction* keyboard_map = nullptr;
  QAction* about = nullptr;
  QActionGroup* themes = nullptr;        // by ThemeChoice
  QActionGroup* languages = nullptr;     // data(): language code, empty: the system's
  QActionGroup* error_scales = nullptr;  // scales of distances
  QActionGroup* angle_scales = nullptr;
  QAction* in_degrees = nullptr;  // switches heat map and graph to angles
  QAction* as_seen = nullptr;     // switches the heat map to visibility
  ViewActions view;
  TransportActions transport;
};

/// Makes actions with texts, icons and shortcuts; the window connects them.
Actions makeActions(Playback* playback, QUndoGroup* history, QMainWindow* window);

/// Gives the actions the names by which the user's keys for them are remembered.
void nameActions(const Actions& actions);

/// Menus that the window fills.
struct RecentMenus {
  QMenu* files = nullptr;
  QMenu* projects = nullptr;
  QMenu* play = nullptr;      // gets the actions on a range
  QMenu* timeline = nullptr;  // gets the strips that can be folded
};

/// Adds menus and tool bar.
RecentMenus addMenus(QMainWindow* window, const Actions& actions, const QList<QDockWidget*>& docks);

/// Reserves keys with Ctrl or Alt for the program's shortcuts while a field has the focus: Qt's
/// line edits use some of them, such as Ctrl+E for the end of the line. Keys that edit text stay
/// with the field. Number fields keep only keys that are part of a number.
class ShortcutsFirst : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace mocapress
