// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/window_layout.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QSettings>

namespace mocapress {
namespace {

constexpr int kLayoutVersion = 6;
const QString kGeometry = QStringLiteral("window/geometry");
const QString kState = QStringLiteral("window/state");

/// Quieter than the style's: the name alone. Drag it to move the dock, double click to float it.
QLabel* makeTitle(const QString& title, QWidget* parent) {
  auto* label = new QLabel(title, parent);
  QFont font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  label->setContentsMargins(10, 7, 10, 5);
  return label;
}

}  // namespace

QDockWidget* WindowLayout::addLeft(QWidget* panel, const QString& id, const QString& title) {
  return add(Qt::LeftDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::addRight(QWidget* panel, const QString& id, const QString& title) {
  return add(Qt::RightDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::addBelow(QWidget* panel, const QString& id, const QString& title) {
  return add(Qt::BottomDockWidgetArea, panel, id, title);
}

QDockWidget* WindowLayout::add(Qt::DockWidgetArea area, QWidget* panel, const QString& id,
                               const QString& title) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(id);
  dock->setTitleBarWidget(makeTitle(title, dock));
  dock->setWidget(panel);
  window_->addDockWidget(area, dock);
  docks_ << dock;
  return dock;
}

void WindowLayout::restore() {
  built_ = window_->saveState(kLayoutVersion);
  const QSettings settings;
  window_->restoreGeometry(settings.value(kGeometry).toByteArray());
  window_->restoreState(settings.value(kState).toByteArray(), kLayoutVersion);
}

void WindowLayout::remember() const {
  QSettings settings;
  settings.setValue(kGeometry, window_->saveGeometry());
  settings.setValue(kState, window_->saveState(kLayoutVersion));
}

void WindowLayout::reset() {
  window_->restoreState(built_, kLayoutVersion);
}

}  // namespace mocapress
