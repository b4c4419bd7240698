// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/metrics/glitches.h"
#include "widgets/models/error_colour.h"
#include "widgets/models/error_profile.h"
#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// The error over time in a narrow strip: the maximum as coloured columns, the mean as a line,
/// one-frame glitches as marks, and the played range. To its left is the scale; a click on the
/// scale opens a menu of the widget's actions. A click or drag seeks; with Shift it chooses the
/// range.
class ErrorStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ErrorStrip(QWidget* parent = nullptr);

  /// Sets the errors of a clip of `frames` frames. Empty profile: unknown.
  void setErrors(ErrorProfile profile, const ErrorScale& scale, int frames);
  void setGlitches(std::vector<Glitch> glitches, std::vector<QString> names);
  void setRange(const std::optional<FrameRange>& range);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Sets the width in pixels for the names at the left, shared with the strips below.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, 50}; }

 signals:
  void seekRequested(int frame);
  void rangeChosen(const mocapress::FrameRange& range);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  TimeAxis axis() const;
  QRectF plotArea() const;
  void showErrors();
  QPixmap paintedErrors() const;
  void paintColumns(QPainter& painter) const;
  void paintMean(QPainter& painter) const;
  void paintScale(QPainter& painter) const;
  void paintGlitches(QPainter& painter) const;
  void paintRange(QPainter& painter) const;
  void pointAt(double x, bool chooses_range);
  void showMenu(const QPoint& global);

  ErrorProfile profile_;
  ErrorScale scale_;
  QPixmap errors_;  // picture of columns and mean, for playing; null: outdated
  std::vector<Glitch> glitches_;
  std::vector<QString> names_;
  std::optional<FrameRange> range_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
  int range_from_ = 0;  // fixed end of the range being dragged
};

}  // namespace mocapress
