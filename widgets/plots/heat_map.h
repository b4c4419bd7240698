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

/// Every landmark's error at every frame at a glance, a distance or an angle: a row a landmark,
/// time to the right, coloured by a scale of either. Or whether the eye sees it, a row a joint. A
/// click seeks and chooses the joint.
class HeatMap : public QWidget {
  Q_OBJECT

 public:
  explicit HeatMap(QWidget* parent = nullptr);

  /// `names` of all landmarks. The scale says which errors are shown.
  void setErrors(ErrorsPtr errors, std::vector<QString> names, const ErrorScale& scale);

  /// Of the same clip; null: unknown. Shown in place of its errors, or told beside them.
  void setSight(SightPtr sight, bool shown);

  /// What switches to other quantities, in the corner.
  void setSwitches(const QList<QAction*>& actions);

  void setFrame(int frame);

  /// The row that is marked; -1: none.
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

  QFont boldFont() const;  // of the current name
  QRectF mapArea() const;
  QRectF rowOf(int landmark) const;
  std::optional<Cell> cellAt(const QPointF& position) const;
  void choose(const QPointF& position);
  QImage paintedImage() const;
  QString describe(const Cell& cell) const;
  void paintLegend(QPainter& painter) const;
  void paintVerdicts(QPainter& painter) const;
  void placeSwitches();

  /// Frames x landmarks; empty: unknown.
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
  QImage image_;  // one pixel a landmark and a stretch of frames
  int frame_ = 0;
  int current_ = -1;
  int names_width_ = 0;
};

/// The picture of a heat map: the worst of the frames that share a column counts.
QImage heatImage(const Eigen::MatrixXf& errors, const ErrorScale& scale, int most_columns);

/// The same of what is seen.
QImage sightImage(const SightTable& sight, int frames, int most_columns);

}  // namespace mocapress
