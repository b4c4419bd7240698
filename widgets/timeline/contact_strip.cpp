// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/contact_strip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/models/slide_colour.h"

namespace mocapress {
namespace {

constexpr int kLaneHeight = 13;  // pixels
constexpr int kLaneGap = 2;
constexpr int kMargin = 8;
constexpr double kCorner = 2;

}  // namespace

ContactStrip::ContactStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Contacts"));
  hide();
}

void ContactStrip::setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                               int frames) {
  contacts_ = std::move(contacts);
  names_ = names;
  frames_ = frames;
  findings_.clear();
  lanes_.clear();
  label_width_ = 0;
  for (const ContactSpan& span : contacts_) {
    if (std::find(lanes_.begin(), lanes_.end(), span.landmark) != lanes_.end()) continue;
    lanes_.push_back(span.landmark);
    label_width_ =
        std::max(label_width_,
                 fontMetrics().horizontalAdvance(names_[static_cast<std::size_t>(span.landmark)]));
  }
  setVisible(!lanes_.empty());
  updateGeometry();
  update();
}

void ContactStrip::setFindings(const std::vector<SlideFinding>& findings) {
  findings_ = findings;
  update();
}

void ContactStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

QSize ContactStrip::sizeHint() const {
  const int lanes = static_cast<int>(lanes_.size());
  return {200, lanes * (kLaneHeight + kLaneGap) + kLaneGap + 4};
}

double ContactStrip::xOf(double frame) const {
  const double left = 2 * kMargin + label_width_;
  return left + (width() - kMargin - left) * frame / std::max(frames_, 1);
}

int ContactStrip::frameAt(double x) const {
  const double share = (x - xOf(0)) / (xOf(frames_) - xOf(0));
  return std::clamp(static_cast<int>(std::floor(share * frames_)), 0, std::max(frames_ - 1, 0));
}

QRectF ContactStrip::barOf(const ContactSpan& span) const {
  const auto lane = std::find(lanes_.begin(), lanes_.end(), span.landmark) - lanes_.begin();
  const double left = xOf(span.first_frame);
  const double top = kLaneGap + 2 + static_cast<double>(lane) * (kLaneHeight + kLaneGap);
  return {left, top, std::max(xOf(span.last_frame + 1) - left, 1.0), kLaneHeight};
}

double ContactStrip::slideOf(const ContactSpan& span) const {
  const auto found = std::find_if(findings_.begin(), findings_.end(),
                                  [&](const SlideFinding& slide) { return slide.span == span; });
  return found == findings_.end() ? 0 : found->slid_cm;
}

QString ContactStrip::describe(const ContactSpan& span) const {
  return tr("%1 on the ground, frames %L2–%L3; slides %L4 cm further than the original")
      .arg(names_[static_cast<std::size_t>(span.landmark)])
      .arg(span.first_frame + 1)
      .arg(span.last_frame + 1)
      .arg(slideOf(span), 0, 'f', 2);
}

void ContactStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const int landmark : lanes_) {
    const QRectF lane = barOf({landmark, 0, std::max(frames_ - 1, 0)});
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(kMargin, lane.top(), label_width_, lane.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, names_[static_cast<std::size_t>(landmark)]);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawRoundedRect(lane, kCorner, kCorner);
  }
  painter.setPen(Qt::NoPen);
  for (const ContactSpan& span : contacts_) {
    painter.setBrush(slideColour(slideOf(span)));
    painter.drawRoundedRect(barOf(span), kCorner, kCorner);
  }
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = xOf(frame_ + 0.5);
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

bool ContactStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (const ContactSpan& span : contacts_) {
    if (!barOf(span).contains(help->pos())) continue;
    QToolTip::showText(help->globalPos(), describe(span), this);
    return true;
  }
  QToolTip::hideText();
  return true;
}

void ContactStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit seekRequested(frameAt(event->position().x()));
}

void ContactStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) emit seekRequested(frameAt(event->position().x()));
}

}  // namespace mocapress
