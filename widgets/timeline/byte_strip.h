// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/codec/format/byte_costs.h"
#include "widgets/timeline/time_axis.h"

namespace mocapress {

using ByteCostsPtr = std::shared_ptr<const ByteCosts>;

/// Compressed bytes over time, of the whole figure. The moment that costs most fills
/// the height. A click or drag shows the frame and the joint that costs most there.
class ByteStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ByteStrip(QWidget* parent = nullptr);

  /// `names` has the names of all joints. Null costs: unknown.
  void setCosts(ByteCostsPtr costs, std::vector<QString> names, int frames);
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Width in pixels for names, in line with the other strips.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, 22}; }

 signals:
  void chosen(int frame, int joint);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  TimeAxis axis() const;
  int sliceAt(double x) const;
  int dearestJoint(int slice) const;
  void choose(double x);

  ByteCostsPtr costs_;
  Eigen::VectorXd rates_;  // bytes of a frame, by slice
  std::vector<QString> names_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
};

}  // namespace mocapress
