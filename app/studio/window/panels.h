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

class ByteCostModel;
class BytesPanel;
class LibraryModel;
class LibraryPanel;
class LibraryPlot;
class MessageBar;
class PanelsBelow;
class PinnedModel;
class PinnedPanel;
class SlotControl;
struct TransportActions;

/// Gives a dock its width back when its window grows again after being too small.
class KeptWidth : public QObject {
  Q_OBJECT

 public:
  KeptWidth(QDockWidget* dock, QMainWindow* window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QDockWidget* dock_;
  QMainWindow* window_;
  int width_ = 0;         // wanted width, from the user or before the window shrank
  int window_width_ = 0;  // width of the window at that time
};

/// The docks around the 3D view, restored from run to run.
class WindowLayout {
 public:
  explicit WindowLayout(QMainWindow* window) : window_(window) {}

  /// Adds a panel on one side; those at the bottom stand side by side.
  QDockWidget* addLeft(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addRight(QWidget* panel, const QString& id, const QString& title);
  QDockWidget* addBelow(QWidget* panel, const QString& id, const QString& title);

  const QList<QDockWidget*>& docks() const { return docks_; }

  /// Shows a panel's dock, raises it above its tabs and unfolds it.
  void bringUp(const QWidget* panel) const;

  /// Called after the last dock: records the initial layout and restores that of the last run.
  /// `view` is the 3D view, for which the docks below make room.
  void restore(const QWidget* view);
  void remember() const;
  void reset();

  PanelsBelow* below() const { return below_; }

 private:
  QDockWidget* add(Qt::DockWidgetArea area, QWidget* panel, const QString& id,
                   const QString& title);

  QMainWindow* window_;
  QList<QDockWidget*> docks_;
  PanelsBelow* below_ = nullptr;
  QByteArray built_;
};

/// The widgets of the main window: 3D view, timeline and transport bar in the middle, the library
/// on the left, settings and figures on the right, joints and errors at the bottom.
struct Panels {
  Views views;
  InspectionViews inspection;
  LibraryPanel* library = nullptr;
  LibraryPlot* library_plot = nullptr;
  SlotControl* slot_control = nullptr;
  PinnedPanel* pinned = nullptr;
  BytesPanel* bytes = nullptr;
  MessageBar* messages = nullptr;
};

/// Data of the lists and tables in Panels.
struct PanelModels {
  Models clip;
  LibraryModel* library = nullptr;
  PinnedModel* pinned = nullptr;
  ByteCostModel* bytes = nullptr;
};

/// Makes the widgets and places them.
Panels makePanels(QMainWindow* window, WindowLayout* layout, const PanelModels& models,
                  Playback* playback, const TransportActions& transport);

}  // namespace mocapress
