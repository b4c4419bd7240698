// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "widgets/models/display_names.h"
#include "widgets/timeline/joint_strip.h"

namespace mocapress {

/// Visibility over time, of the joint with the most visible error: no column where the error is not
/// visible, half a column where it is borderline, a full one where it is visible.
class SightStrip : public JointStrip {
  Q_OBJECT

 public:
  explicit SightStrip(QWidget* parent = nullptr);

  /// `names` has the names of all joints.
  void setSight(SightPtr sight, std::vector<QString> names, int frames);

 private:
  bool isKnown() const override { return sight_ != nullptr; }
  void paintColumns(QPainter& painter, const QRectF& area, const TimeAxis& time) const override;
  int jointAt(int frame) const override { return sight_->at(frame).joint; }
  QString meaning() const override;
  QString describe(int frame) const override;

  SightPtr sight_;
  Eigen::VectorXf worst_;  // of the worst joint, one entry for each time window
};

}  // namespace mocapress
