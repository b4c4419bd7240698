// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <vector>

#include "widgets/models/display_names.h"
#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// Visibility over time, of the joint with the most visible error: no column where it is not
/// visible, half a column where it is borderline, a whole one where it is visible. A click or drag
/// shows frame and joint.
class SightStrip : public QWidget {
  Q_OBJECT

 public:
  explicit SightStrip(QWidget* parent = nullptr);

  /// `names` has the names of all joints.
  void setSight(SightPtr sight, std::vector<QString> names, int frames);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Width in pixels for names, in line with the other strips.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, 17}; }

 signals:
  void chosen(int frame, int joint);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  TimeAxis axis() const;
  void choose(double x);
  void paintColumns(QPainter& painter, const QRectF& area) const;

  SightPtr sight_;
  Eigen::VectorXf worst_;  // worst joint of each window
  std::vector<QString> names_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
};

}  // namespace mocapress
