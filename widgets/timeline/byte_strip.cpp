// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/byte_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace mocapress {
namespace {

constexpr int kBytesTop = 4;

}  // namespace

ByteStrip::ByteStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Bytes over time"));
  setAccessibleDescription(tr("Compressed bytes over time. The table of bytes has them by joint."));
}

void ByteStrip::setCosts(ByteCostsPtr costs, std::vector<QString> names, int frames) {
  costs_ = costs && costs->bytes.sum() > 0 ? std::move(costs) : nullptr;
  names_ = std::move(names);
  frames_ = frames;
  rates_ = costs_ ? costs_->by_slice() / costs_->slice_frames : Eigen::VectorXd();
  if (const Eigen::Index last = rates_.size() - 1; last >= 0)  // may be shorter
    rates_(last) *= static_cast<double>(costs_->slice_frames) /
                    std::max<double>(1, frames - static_cast<double>(last) * costs_->slice_frames);
  update();
}

void ByteStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void ByteStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void ByteStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int ByteStrip::labelWidth() const {
  return fontMetrics().horizontalAdvance(tr("Bytes"));
}

TimeAxis ByteStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

int ByteStrip::sliceAt(double x) const {
  return std::min(axis().frameAt(x) / costs_->slice_frames, static_cast<int>(rates_.size()) - 1);
}

int ByteStrip::dearestJoint(int slice) const {
  Eigen::Index joint = 0;
  costs_->bytes.row(slice).maxCoeff(&joint);
  return static_cast<int>(joint);
}

void ByteStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  const QRectF area(time.left, kBytesTop, time.right - time.left, height() - kBytesTop);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(kStripMargin, area.top(), label_width_, area.height()),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("Bytes"));
  painter.fillRect(area, palette().color(QPalette::AlternateBase));
  painter.setClipRect(QRectF(area.left(), 0, area.width(), height()));
  if (costs_) {
    QColor colour = palette().color(QPalette::Highlight);
    colour.setAlphaF(0.6F);
    const double most = rates_.maxCoeff();
    for (double x = area.left(); x < area.right(); ++x) {
      const double height = area.height() * rates_(sliceAt(x)) / most;
      painter.fillRect(QRectF(x, area.bottom() - height, 1, height), colour);
    }
  }
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = time.xOf(frame_ + 0.5);
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

bool ByteStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text = tr("Compressed bytes over time, on a scale of the dearest moment.");
  if (costs_ && help->pos().x() >= axis().left) {
    const int slice = sliceAt(help->pos().x());
    const int joint = dearestJoint(slice);
    text = tr("Frames from %L1: %L2 bytes, most of them for %3 (%L4)")
               .arg(slice * costs_->slice_frames + 1)
               .arg(costs_->bytes.row(slice).sum(), 0, 'f', 0)
               .arg(names_[static_cast<std::size_t>(joint)])
               .arg(costs_->bytes(slice, joint), 0, 'f', 0);
  }
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void ByteStrip::choose(double x) {
  if (costs_) emit chosen(axis().frameAt(x), dearestJoint(sliceAt(x)));
}

void ByteStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position().x());
}

void ByteStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) choose(event->position().x());
}

}  // namespace mocapress
