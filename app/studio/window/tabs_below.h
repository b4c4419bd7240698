// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace mocapress {

/// The visible bars with the tabs of the docks below the central widget.
QList<QTabBar*> tabBarsBelow(const QMainWindow* window);

/// True if no tab of a visible bar is cut off.
bool tabsFit(const QList<QTabBar*>& bars);

/// Makes room for the tabs below: they get the corner below the library if they need it, and docks
/// in front that stand side by side get widths that fit their tabs.
void fitTabs(QMainWindow* window, const QList<QDockWidget*>& in_front);

}  // namespace mocapress
