// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QTimer>
#include <QWidget>

class QCPGraph;
class QCPItemText;
class QCustomPlot;

namespace mocapress {

class LibraryFilter;

/// Plots the clips that pass the library's filter as points, error over ratio, both logarithmic,
/// coloured by visibility. A click opens a clip; the wheel zooms, dragging moves, a double click
/// beside the points shows all.
class LibraryPlot : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPlot(const LibraryFilter* clips, QWidget* parent = nullptr);

  /// Draws a ring around the point of a clip, given by its row in the library; -1: none.
  void setCurrent(int clip);

  /// The position of a clip's point in pixels of this widget. The clip must have an outcome.
  QPoint positionOf(int clip) const;

 signals:
  void openRequested(int clip);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void connectMouse();
  void redrawSoon();
  void redraw();
  void placeRing();
  void showAll();
  void hover(const QPoint& position);
  int clipAt(const QPoint& position) const;  // -1: none is near

  const LibraryFilter* clips_;
  QCustomPlot* plot_;
  QCPItemText* hint_;
  QCPGraph* ring_ = nullptr;
  QTimer redraw_later_;  // delays drawing: thousands of clips may change at once
  int current_ = -1;
  bool moved_ = false;  // the user moved the axes: new points do not move them
  QPoint pressed_at_;
};

}  // namespace mocapress
