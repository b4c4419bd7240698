// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/codec/format/byte_costs.h"
#include "widgets/timeline/joint_strip.h"

namespace mocapress {

using ByteCostsPtr = std::shared_ptr<const ByteCosts>;

/// Compressed bytes over time, of all joints together. The most expensive slice of the clip fills
/// the height. A click on a frame chooses the joint with the most bytes in
/// its slice.
class ByteStrip : public JointStrip {
  Q_OBJECT

 public:
  explicit ByteStrip(QWidget* parent = nullptr);

  /// `names` has the names of all joints. Null costs: unknown.
  void setCosts(ByteCostsPtr costs, std::vector<QString> names, int frames);

 private:
  bool isKnown() const override { return costs_ != nullptr; }
  void paintColumns(QPainter& painter, const QRectF& area, const TimeAxis& time) const override;
  int jointAt(int frame) const override;
  QString meaning() const override;
  QString describe(int frame) const override;
  int sliceAt(int frame) const;

  ByteCostsPtr costs_;
  Eigen::VectorXd rates_;  // bytes per frame, one entry for each slice of the clip
};

}  // namespace mocapress
