// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace mocapress {

class ErrorGraph;
class Playback;
class Timeline;

/// Compares original and compressed figure within the range that is played: it loops, both figures
/// stand side by side, and timeline and error graph show the range alone. Ends with the range and
/// restores the former state.
class RangeComparison : public QObject {
  Q_OBJECT

 public:
  /// Actions of the window that are set at the start and restored at the end.
  struct Switches {
    QAction* overlay = nullptr;  // the one way of viewing that does not show both figures whole
    QAction* side_by_side = nullptr;
    QAction* quarters = nullptr;  // views with both figures overlaid, whatever the way
    QAction* loop = nullptr;
  };

  /// `toggle` starts and ends the comparison.
  RangeComparison(Playback* playback, Timeline* timeline, ErrorGraph* graph, QAction* toggle,
                  const Switches& switches, QObject* parent = nullptr);

 private:
  void start();
  void end();
  void showRange();

  Playback* playback_;
  Timeline* timeline_;
  ErrorGraph* graph_;
  QAction* toggle_;
  Switches switches_;
  bool was_overlay_ = false;
  bool was_quartered_ = false;
  bool did_loop_ = false;
};

}  // namespace mocapress
