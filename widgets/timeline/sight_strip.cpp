// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/sight_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/models/colours.h"

namespace mocapress {
namespace {

constexpr int kFree = 4;

}  // namespace

SightStrip::SightStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Visible errors"));
  setAccessibleDescription(
      tr("Times at which errors are visible. The heat map shows them by joint."));
}

void SightStrip::setSight(SightPtr sight, std::vector<QString> names, int frames) {
  sight_ = sight && sight->windows() > 0 ? std::move(sight) : nullptr;
  worst_ = sight_ ? sight_->times_noticed.rowwise().maxCoeff() : Eigen::VectorXf();
  names_ = std::move(names);
  frames_ = frames;
  update();
}

void SightStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void SightStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void SightStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int SightStrip::labelWidth() const {
  return fontMetrics().horizontalAdvance(tr("Seen"));
}

TimeAxis SightStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void SightStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  const QRectF area(time.left, kFree, time.right - time.left, height() - kFree);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(kStripMargin, area.top(), label_width_, area.height()),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("Seen"));
  painter.fillRect(area, palette().color(QPalette::AlternateBase));
  if (sight_) paintColumns(painter, area);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = time.xOf(frame_ + 0.5);
  painter.setClipRect(QRectF(area.left(), 0, area.width(), height()));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

/// Draws one column for each pixel with the worst of its windows.
void SightStrip::paintColumns(QPainter& painter, const QRectF& area) const {
  const TimeAxis time = axis();
  for (double x = area.left(); x < area.right(); ++x) {
    const int first = sight_->window_of(time.frameAt(x));
    const int last = sight_->window_of(time.frameAt(x + 1));
    const float most = worst_.segment(first, std::max(last - first, 1)).maxCoeff();
    const Sight sight = sight_of(static_cast<double>(most));
    if (sight == Sight::NotVisible) continue;
    const double height = area.height() / (sight == Sight::Visible ? 1 : 2);
    painter.fillRect(QRectF(x, area.bottom() - height, 1, height), sightColour(sight));
  }
}

bool SightStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text =
      tr("Times at which errors are visible (full column) or borderline (half a column).");
  if (sight_ && help->pos().x() >= axis().left) {
    const WorstSight seen = sight_->at(axis().frameAt(help->pos().x()));
    text =
        tr("%1, frame %L2").arg(names_[static_cast<std::size_t>(seen.joint)]).arg(seen.frame + 1) +
        QLatin1Char('\n') + sightText(seen);
  }
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void SightStrip::choose(double x) {
  const int frame = axis().frameAt(x);
  if (sight_) emit chosen(frame, sight_->at(frame).joint);
}

void SightStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position().x());
}

void SightStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) choose(event->position().x());
}

}  // namespace mocapress
