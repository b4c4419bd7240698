// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QToolBar;

namespace mocapress {

class Viewport;
struct ViewOptions;

/// Display of the figures in the 3D view.
struct ViewActions {
  QActionGroup* modes = nullptr;
  std::array<QAction*, 3> mode{};  // indexed by ViewMode
  QAction* quarters = nullptr;     // four views at once
  QAction* swap = nullptr;
  QAction* blink = nullptr;
  QAction* by_error = nullptr;
  QAction* skin = nullptr;
  QAction* path = nullptr;
  QAction* trail = nullptr;
  QActionGroup* trail_poses = nullptr;  // data(): poses before the current frame, and as many after
  QAction* exaggerate = nullptr;
  QActionGroup* exaggeration = nullptr;  // data(): factor on the difference
  QAction* in_place = nullptr;
  QAction* front = nullptr;
  QAction* side = nullptr;
  QAction* floor = nullptr;
  QAction* follow = nullptr;
  QAction* reset_camera = nullptr;
  QAction* frame_joint = nullptr;
  std::array<QAction*, 4> go_to{};  // camera places that are kept from run to run
  std::array<QAction*, 4> keep{};
};

/// Makes actions with texts, icons and shortcuts.
ViewActions makeViewActions(QMainWindow* window);

/// Connects the actions to a view.
void connectViewActions(const ViewActions& actions, Viewport* viewport);

/// Sets the actions and the view to these options.
void showOptions(const ViewActions& actions, Viewport* viewport, const ViewOptions& options);

void addInGroups(QMenu* menu, const ViewActions& actions);
void addInGroups(QToolBar* bar, const ViewActions& actions);

}  // namespace mocapress
