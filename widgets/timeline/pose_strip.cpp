// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/pose_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kAround = 2;       // pixels above and below the figures
constexpr int kMeasured = 48;       // number of poses that set the scale
constexpr double kAzimuth = 0.66;   // radians; from the front right, like the 3D view at first
constexpr double kWidestShare = 1;  // greatest half width of a figure, per height

}  // namespace

PoseStrip::PoseStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Poses over time"));
  setToolTip(tr("Poses of the clip along the time; a click goes there."));
  hide();
}

void PoseStrip::setPoses(std::shared_ptr<const Eigen::MatrixXd> tracks, std::vector<int> parents,
                         int root) {
  root_ = root;
  tracks_ = tracks && tracks->rows() > 0 && !parents.empty() ? std::move(tracks) : nullptr;
  parents_ = std::move(parents);
  if (tracks_) measure();
  setVisible(tracks_ != nullptr);
  update();
}

void PoseStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void PoseStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void PoseStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int PoseStrip::labelWidth() const {
  return fontMetrics().horizontalAdvance(tr("Poses"));
}

TimeAxis PoseStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin),
          tracks_ ? static_cast<int>(tracks_->rows()) : 0, window_};
}

QPointF PoseStrip::seen(int frame, int joint) const {
  const double x = (*tracks_)(frame, 3 * joint) - (*tracks_)(frame, 3 * root_);
  const double z = (*tracks_)(frame, 3 * joint + 2) - (*tracks_)(frame, 3 * root_ + 2);
  return {std::cos(kAzimuth) * x - std::sin(kAzimuth) * z, (*tracks_)(frame, 3 * joint + 1)};
}

void PoseStrip::measure() {
  lowest_ = 1e9;
  highest_ = -1e9;
  half_width_ = 0;
  const auto frames = static_cast<int>(tracks_->rows());
  for (int i = 0; i < kMeasured; ++i)
    for (int joint = root_; joint < static_cast<int>(parents_.size()); ++joint) {
      const QPointF point = seen(i * (frames - 1) / (kMeasured - 1), joint);
      lowest_ = std::min(lowest_, point.y());
      highest_ = std::max(highest_, point.y());
      half_width_ = std::max(half_width_, std::abs(point.x()));
    }
  highest_ = std::max(highest_, lowest_ + 1e-3);
  half_width_ = std::min(half_width_, kWidestShare * (highest_ - lowest_));
}

void PoseStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(kStripMargin, 0, label_width_, height()),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("Poses"));
  if (!tracks_) return;
  const QRectF area(time.left, 0, time.right - time.left, height());
  painter.setClipRect(area);
  const double scale = (height() - 2 * kAround) / (highest_ - lowest_);  // pixels per cm
  const double apart = std::max(2.2 * scale * half_width_, 8.0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QColor colour = palette().color(QPalette::WindowText);
  colour.setAlphaF(0.75F);
  painter.setPen(QPen(colour, 1.2, Qt::SolidLine, Qt::RoundCap));
  for (double x = time.left + apart / 2; x + apart / 2 <= time.right; x += apart) {
    const int frame = time.frameAt(x);
    const auto place = [&](int joint) {
      const QPointF point = seen(frame, joint);
      return QPointF(x + scale * point.x(), height() - kAround - scale * (point.y() - lowest_));
    };
    for (int joint = root_ + 1; joint < static_cast<int>(parents_.size()); ++joint) {
      const int parent = parents_[static_cast<std::size_t>(joint)];
      if (parent >= root_) painter.drawLine(place(parent), place(joint));
    }
  }
  painter.restore();
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = time.xOf(frame_ + 0.5);
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

void PoseStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && tracks_)
    emit seekRequested(axis().frameAt(event->position().x()));
}

void PoseStrip::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) && tracks_)
    emit seekRequested(axis().frameAt(event->position().x()));
}

}  // namespace mocapress
