// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/codec/encode/options/important_range.h"
#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// A ruler above the other strips, with frames above and seconds below. It shows the chosen range,
/// and the ranges that are compressed with more care. A click seeks, a drag chooses a range, and
/// both ends of the range can be dragged. A click on a range with more care chooses it; a double
/// click chooses no range. The right button opens a menu of the widget's actions.
class TimeRuler : public QWidget {
  Q_OBJECT

 public:
  explicit TimeRuler(QWidget* parent = nullptr);

  void setClip(int frames, double sample_rate_hz);
  void setRange(const std::optional<FrameRange>& range);
  void setCare(std::vector<ImportantRange> care);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Sets the width in pixels for the names at the left, shared with the strips below.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  /// The distance in frames between two numbers: 1, 2 or 5 times a power of ten.
  int framesApart() const;

  QSize sizeHint() const override;

 signals:
  void seekRequested(int frame);
  void rangeChosen(const std::optional<mocapress::FrameRange>& range);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  TimeAxis axis() const;
  int rowHeight() const;
  QRectF barOf(const ImportantRange& care) const;
  const ImportantRange* careAt(const QPointF& position) const;  // null: none
  std::optional<int> endAt(double x) const;  // if x is at an end of the range, the other end
  void paintFrames(QPainter& painter) const;
  void paintSeconds(QPainter& painter) const;
  void paintCare(QPainter& painter) const;
  QString describe(const ImportantRange& care) const;

  int frames_ = 0;
  double sample_rate_hz_ = 120;
  std::optional<FrameRange> range_;
  std::vector<ImportantRange> care_;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
  double pressed_x_ = 0;
  bool drags_ = false;  // true once the mouse has moved far enough from the press
  int range_from_ = 0;  // fixed end of the range being dragged
};

}  // namespace mocapress
