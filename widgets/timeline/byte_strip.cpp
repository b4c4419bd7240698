// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/byte_strip.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace mocapress {

ByteStrip::ByteStrip(QWidget* parent) : JointStrip(tr("Bytes"), 22, parent) {
  setAccessibleName(tr("Bytes over time"));
  setAccessibleDescription(tr("Compressed bytes over time. The table of bytes has them by joint."));
}

void ByteStrip::setCosts(ByteCostsPtr costs, std::vector<QString> names, int frames) {
  costs_ = costs && costs->bytes.sum() > 0 ? std::move(costs) : nullptr;
  rates_ = costs_ ? costs_->by_slice() / costs_->slice_frames : Eigen::VectorXd();
  if (const Eigen::Index last = rates_.size() - 1; last >= 0)  // it may be shorter
    rates_(last) *= static_cast<double>(costs_->slice_frames) /
                    std::max<double>(1, frames - static_cast<double>(last) * costs_->slice_frames);
  setClip(std::move(names), frames);
}

int ByteStrip::sliceAt(int frame) const {
  return std::min(frame / costs_->slice_frames, static_cast<int>(rates_.size()) - 1);
}

int ByteStrip::jointAt(int frame) const {
  Eigen::Index joint = 0;
  costs_->bytes.row(sliceAt(frame)).maxCoeff(&joint);
  return static_cast<int>(joint);
}

void ByteStrip::paintColumns(QPainter& painter, const QRectF& area, const TimeAxis& time) const {
  QColor colour = palette().color(QPalette::Highlight);
  colour.setAlphaF(0.6F);
  const double most = rates_.maxCoeff();
  for (double x = area.left(); x < area.right(); ++x) {
    const double height = area.height() * rates_(sliceAt(time.frameAt(x))) / most;
    painter.fillRect(QRectF(x, area.bottom() - height, 1, height), colour);
  }
}

QString ByteStrip::meaning() const {
  return tr("Compressed bytes over time, on a scale of the dearest moment.");
}

QString ByteStrip::describe(int frame) const {
  const int slice = sliceAt(frame);
  const int joint = jointAt(frame);
  return tr("Frames from %L1: %L2 bytes, most of them for %3 (%L4)")
      .arg(slice * costs_->slice_frames + 1)
      .arg(costs_->bytes.row(slice).sum(), 0, 'f', 0)
      .arg(nameOf(joint))
      .arg(costs_->bytes(slice, joint), 0, 'f', 0);
}

}  // namespace mocapress
