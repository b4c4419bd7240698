// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QToolButton>

namespace mocapress {

/// An action as a word in the corner of a plot. With a frame: without, it reads as the unit of what
/// is shown. A click leaves the keys with the plot.
class SwitchButton : public QToolButton {
 public:
  SwitchButton(QAction* action, QWidget* plot) : QToolButton(plot) {
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
  }
};

}  // namespace mocapress
