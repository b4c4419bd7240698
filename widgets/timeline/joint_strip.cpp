// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/joint_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <utility>

namespace mocapress {
namespace {

constexpr int kTop = 4;  // pixels free above the columns

}  // namespace

JointStrip::JointStrip(const QString& label, int height, QWidget* parent)
    : QWidget(parent), label_(label), height_(height) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void JointStrip::setClip(std::vector<QString> names, int frames) {
  names_ = std::move(names);
  frames_ = frames;
  update();
}

void JointStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void JointStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void JointStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int JointStrip::labelWidth() const {
  return fontMetrics().horizontalAdvance(label_);
}

TimeAxis JointStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void JointStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  const QRectF area(time.left, kTop, time.right - time.left, height() - kTop);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(kStripMargin, area.top(), label_width_, area.height()),
                   Qt::AlignLeft | Qt::AlignVCenter, label_);
  painter.fillRect(area, palette().color(QPalette::AlternateBase));
  painter.setClipRect(QRectF(area.left(), 0, area.width(), height()));
  if (isKnown()) paintColumns(painter, area, time);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = time.xOf(frame_ + 0.5);
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

bool JointStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const bool on_columns = isKnown() && help->pos().x() >= axis().left;
  QToolTip::showText(help->globalPos(),
                     on_columns ? describe(axis().frameAt(help->pos().x())) : meaning(), this);
  return true;
}

void JointStrip::choose(double x) {
  const int frame = axis().frameAt(x);
  if (isKnown()) emit chosen(frame, jointAt(frame));
}

void JointStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position().x());
}

void JointStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) choose(event->position().x());
}

}  // namespace mocapress
