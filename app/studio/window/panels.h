// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>

#include "app/studio/compare/inspector.h"
#include "app/studio/compare/presenter.h"

class QDockWidget;
class QMainWindow;
class QWidget;

namespace mocapress {

class LibraryModel;
class LibraryPanel;
class MessageBar;
class PinnedModel;
class PinnedPanel;
class SlotControl;
struct TransportActions;

/// A dock that gets its width back when its window, which was too small for it, grows.
class KeptWidth : public QObject {
  Q_OBJECT

 public:
  KeptWidth(QDockWidget* dock, QMainWindow* window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QDockWidget* dock_;
  QMainWindow* window_;
  int width_ = 0;         // before the window was too small, or as the user dragged it
  int window_width_ = 0;  // that the dock has its place in
};

/// Docks around the 3D view, remembered from run to run.
class WindowLayout {
 public:
  explicit WindowLayout(QMainWindow* window) : window_(window) {}

  /// One panel to either side, others side by side below.
  QDockWidget* addLeft(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addRight(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addBelow(QWidget* panel, const QString& id, const QString& title);

  const QList<QDockWidget*>& docks() const { return docks_; }

  /// Shows the dock of a panel, before the tabs that hide it.
  void bringUp(const QWidget* panel) const;

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

/// All that the main window shows: 3D view, timeline and transport in the middle, the library to
/// the left, settings and figures to the right, joints and their errors below.
struct Panels {
  Views views;
  InspectionViews inspection;
  LibraryPanel* library = nullptr;
  SlotControl* slot_control = nullptr;
  PinnedPanel* pinned = nullptr;
  MessageBar* messages = nullptr;
};

/// What lists and tables of them show.
struct PanelModels {
  Models clip;
  LibraryModel* library = nullptr;
  PinnedModel* pinned = nullptr;
};

/// Makes and places them.
Panels makePanels(QMainWindow* window, WindowLayout* layout, const PanelModels& models,
                  Playback* playback, const TransportActions& transport);

}  // namespace mocapress
