// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/tabs_below.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QTabBar>
#include <algorithm>

namespace mocapress {

QList<QTabBar*> tabBarsBelow(const QMainWindow* window) {
  const QRect centre = window->centralWidget()->geometry();
  QList<QTabBar*> below;
  for (auto* bar : window->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
    if (bar->isVisible() && bar->y() > centre.bottom() && bar->x() < centre.right()) below << bar;
  return below;
}

bool tabsFit(const QList<QTabBar*>& bars) {
  return std::all_of(bars.begin(), bars.end(), [](const QTabBar* bar) {
    return !bar->isVisible() || bar->width() >= bar->sizeHint().width();
  });
}

void fitTabs(QMainWindow* window, const QList<QDockWidget*>& in_front) {
  const QList<QTabBar*> bars = tabBarsBelow(window);
  int wanted = 0;
  for (const QTabBar* bar : bars) wanted += bar->sizeHint().width();
  window->setCorner(Qt::BottomLeftCorner, wanted > window->centralWidget()->width()
                                              ? Qt::BottomDockWidgetArea
                                              : Qt::LeftDockWidgetArea);
  if (tabsFit(bars)) return;
  QList<QDockWidget*> docks;
  QList<int> widths;
  for (QDockWidget* dock : in_front)
    for (const QTabBar* bar : bars)
      if (dock->geometry().left() <= bar->x() && bar->x() <= dock->geometry().right()) {
        docks << dock;
        widths << bar->sizeHint().width();
      }
  window->resizeDocks(docks, widths, Qt::Horizontal);
}

}  // namespace mocapress
