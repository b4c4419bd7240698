// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <memory>
#include <vector>

#include "widgets/timeline/time_axis.h"

namespace mocapress {

/// Small stick figures along the clip's time, each with the pose at its place. A click or drag
/// seeks.
class PoseStrip : public QWidget {
  Q_OBJECT

 public:
  explicit PoseStrip(QWidget* parent = nullptr);

  /// Sets the positions of all landmarks (frames x 3 * landmarks, cm) and the parent of each joint.
  /// Joints from `root` on are drawn. Null tracks: nothing is drawn.
  void setPoses(std::shared_ptr<const Eigen::MatrixXd> tracks, std::vector<int> parents, int root);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Sets the width in pixels for the names at the left, shared with the other strips.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, 32}; }

 signals:
  void seekRequested(int frame);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  TimeAxis axis() const;
  void measure();
  QPointF seen(int frame, int joint) const;  // cm: sideways from the root, and up

  std::shared_ptr<const Eigen::MatrixXd> tracks_;
  std::vector<int> parents_;
  int root_ = 0;
  double lowest_ = 0;   // cm; all figures share the scale and the ground
  double highest_ = 1;  // cm
  double half_width_ = 1;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
};

}  // namespace mocapress
