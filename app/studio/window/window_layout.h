// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace mocapress {

/// Docks around the 3D view, remembered from run to run.
class WindowLayout {
 public:
  explicit WindowLayout(QMainWindow* window) : window_(window) {}

  /// One panel to either side, others side by side below.
  QDockWidget* addLeft(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addRight(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addBelow(QWidget* panel, const QString& id, const QString& title);

  const QList<QDockWidget*>& docks() const { return docks_; }

  /// After the last dock: notes the layout as built, and restores the one of the last run.
  void restore();
  void remember() const;
  void reset();

 private:
  QDockWidget* add(Qt::DockWidgetArea area, QWidget* panel, const QString& id,
                   const QString& title);

  QMainWindow* window_;
  QList<QDockWidget*> docks_;
  QByteArray built_;
};

}  // namespace mocapress
