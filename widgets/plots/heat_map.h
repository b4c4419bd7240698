// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/models/error_colour.h"

namespace mocapress {

/// Every landmark's error at every frame at a glance: a row a landmark, time to the right, coloured
/// as in the 3D view. A click seeks and chooses the joint.
class HeatMap : public QWidget {
  Q_OBJECT

 public:
  using Distances = std::shared_ptr<const Eigen::MatrixXf>;  // frames x landmarks, cm

  explicit HeatMap(QWidget* parent = nullptr);

  /// `names` of all landmarks; null distances: unknown.
  void setDistances(Distances distances, std::vector<QString> names, const ErrorScale& scale);
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
  void paintLegend(QPainter& painter) const;
  int rows() const { return distances_ ? static_cast<int>(distances_->cols()) : 0; }

  Distances distances_;
  std::vector<QString> names_;
  ErrorScale scale_;
  QImage image_;  // one pixel a landmark and a stretch of frames
  int frame_ = 0;
  int current_ = -1;
  int names_width_ = 0;
};

/// The picture of a heat map: the worst of the frames that share a column counts.
QImage heatImage(const Eigen::MatrixXf& distances, const ErrorScale& scale, int most_columns);

}  // namespace mocapress
