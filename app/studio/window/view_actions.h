// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <array>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QToolBar;

namespace mocapress {

class Viewport;

/// How the 3D view shows the figures.
struct ViewActions {
  QActionGroup* modes = nullptr;
  std::array<QAction*, 3> mode{};  // by ViewMode
  QAction* swap = nullptr;
  QAction* blink = nullptr;
  QAction* by_error = nullptr;
  QAction* skin = nullptr;
  QAction* path = nullptr;
  QAction* trail = nullptr;
  QActionGroup* trail_poses = nullptr;  // data(): how many before now, and after
  QAction* in_place = nullptr;
  QAction* floor = nullptr;
  QAction* follow = nullptr;
  QAction* reset_camera = nullptr;

  /// For menus and tool bars, with separators (null) between groups.
  QList<QAction*> inGroups() const;
};

/// With texts, icons and shortcuts.
ViewActions makeViewActions(QMainWindow* window);

/// With effect on a view.
void connectViewActions(const ViewActions& actions, Viewport* viewport);

void addInGroups(QMenu* menu, const ViewActions& actions);
void addInGroups(QToolBar* bar, const ViewActions& actions);

}  // namespace mocapress
