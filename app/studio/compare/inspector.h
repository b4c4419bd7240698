// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <map>
#include <vector>

class QAction;
class QWidget;

namespace mocapress {

class ChannelGraph;
class ClipCurve;
class ErrorDisplay;
class FiguresBar;
class HeatMap;
class Playback;
class RangeActions;
class RatePlot;
class Session;
class Timeline;

/// The views that show time, place and size of the errors.
struct InspectionViews {
  Timeline* timeline = nullptr;
  HeatMap* heat_map = nullptr;
  ChannelGraph* channel = nullptr;
  RatePlot* curve = nullptr;
  FiguresBar* figures = nullptr;
};

/// Shows the session's document in InspectionViews, and passes the user's actions on.
class Inspector : public QObject {
  Q_OBJECT

 public:
  Inspector(Session* session, Playback* playback, const InspectionViews& views,
            ErrorDisplay* error_display, QObject* parent = nullptr);

  /// Moves the playhead to the next worst frame, or back.
  void showNextWorst(int step);

  RangeActions* rangeActions() const { return range_actions_; }
  const ClipCurve& curve() const { return *curve_; }

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Runs `show` now if `view` is visible, else when it is shown, so that hidden plots cost
  /// nothing.
  void whenSeen(QWidget* view, std::function<void()> show);

  void connectViews();
  void showErrors();
  void showErrorScales();
  void showContacts();
  void showRanges();
  void showRangeErrors();
  void showPoses();
  void showJoint();
  void showChannel();
  void drawChannel();
  void showCurve();
  void drawCurve();
  void chooseCell(int frame, int landmark);
  void chooseRatio(int point);

  Session* session_;
  Playback* playback_;
  InspectionViews views_;
  ErrorDisplay* error_display_;
  ClipCurve* curve_;
  RangeActions* range_actions_;
  QAction* map_rule_;  // above the scales in the heat map's menu
  QList<QAction*> map_actions_;
  std::map<QObject*, std::function<void()>> waiting_;
  std::vector<int> worst_;  // frames, worst first
  int shown_worst_ = -1;    // frame of worst_ that was visited last; -1: none
  int channel_ = 0;         // index among the current joint's channels
};

}  // namespace mocapress
