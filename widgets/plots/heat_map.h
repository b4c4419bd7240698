// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/models/display_names.h"
#include "widgets/models/error_colour.h"

namespace mocapress {

class SwitchButton;

/// Shows the error of every landmark at every frame: a row for each landmark, time to the right,
/// coloured by distance or by angle. It can also show visibility, with a row for each joint. A
/// click seeks and chooses the joint.
class HeatMap : public QWidget {
  Q_OBJECT

 public:
  explicit HeatMap(QWidget* parent = nullptr);

  /// Sets the errors and the names of all landmarks. The scale decides which quantity is shown.
  void setErrors(ErrorsPtr errors, std::vector<QString> names, const ErrorScale& scale);

  /// Sets the visibility for the same clip; null: unknown. If `shown`, it is drawn instead of the
  /// errors; otherwise it is only in the tool tip.
  void setSight(SightPtr sight, bool shown);

  /// Sets the actions in the corner that switch to other quantities.
  void setSwitches(const QList<QAction*>& actions);

  void setFrame(int frame);

  /// Marks a landmark's row; -1: none.
  void setCurrentLandmark(int landmark);

  QSize sizeHint() const override { return {400, 200}; }
  QSize minimumSizeHint() const override { return {120, 60}; }

 signals:
  void chosen(int frame, int landmark);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Cell {
    int frame;
    int landmark;
  };

  QFont boldFont() const;  // font of the marked name
  QRectF mapArea() const;
  QRectF rowOf(int landmark) const;
  std::optional<Cell> cellAt(const QPointF& position) const;
  void choose(const QPointF& position);
  QImage paintedImage() const;
  QString describe(const Cell& cell) const;
  void paintLegend(QPainter& painter) const;
  void paintVerdicts(QPainter& painter) const;
  void placeSwitches();

  /// The shown errors, frames x landmarks; empty: unknown.
  const Eigen::MatrixXf& shown() const;
  bool showsSight() const { return sight_ && sight_shown_; }
  int frames() const { return static_cast<int>(shown().rows()); }
  int rows() const {
    return static_cast<int>(showsSight() ? sight_->times_noticed.cols() : shown().cols());
  }

  ErrorsPtr errors_;
  std::vector<QString> names_;
  ErrorScale scale_;
  SightPtr sight_;
  bool sight_shown_ = false;
  std::vector<SwitchButton*> switches_;
  QImage image_;  // one pixel for each landmark and group of frames
  int frame_ = 0;
  int current_ = -1;
  int names_width_ = 0;
};

/// Makes the picture of a heat map of errors. A column shows the largest error of its frames.
QImage heatImage(const Eigen::MatrixXf& errors, const ErrorScale& scale, int most_columns);

/// Makes the picture of a heat map of visibility.
QImage sightImage(const SightTable& sight, int frames, int most_columns);

}  // namespace mocapress
