// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/contact_strip.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/models/colours.h"
#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

constexpr int kLaneHeight = 13;  // pixels
constexpr int kLaneGap = 2;
constexpr double kCorner = 2;
constexpr double kHandleReach = 5;  // pixels on both sides of a bar's end

}  // namespace

ContactStrip::ContactStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Contacts"));
  setMouseTracking(true);
  hide();
}

void ContactStrip::setContacts(std::vector<ContactSpan> contacts, const std::vector<QString>& names,
                               int frames) {
  // A foot without contacts keeps its lane, so that contacts can be added again.
  if (names != names_ || frames != frames_) lanes_.clear();
  contacts_ = std::move(contacts);
  names_ = names;
  frames_ = frames;
  findings_.clear();
  dragged_.reset();
  for (const ContactSpan& span : contacts_) {
    if (std::find(lanes_.begin(), lanes_.end(), span.landmark) != lanes_.end()) continue;
    lanes_.push_back(span.landmark);
  }
  std::sort(lanes_.begin(), lanes_.end());
  names_width_ = 0;
  for (const int lane : lanes_)
    names_width_ = std::max(
        names_width_, fontMetrics().horizontalAdvance(names_[static_cast<std::size_t>(lane)]));
  label_width_ = names_width_;
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

void ContactStrip::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

TimeAxis ContactStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void ContactStrip::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

std::optional<ContactStrip::Handle> ContactStrip::handleAt(const QPointF& position) const {
  std::optional<Handle> nearest;
  double least = kHandleReach;
  for (int i = 0; i < static_cast<int>(contacts_.size()); ++i) {
    const QRectF bar = barOf(contacts_[static_cast<std::size_t>(i)]);
    if (position.y() < bar.top() || position.y() > bar.bottom()) continue;
    for (const auto& [x, end] :
         {std::pair(bar.left(), SpanEnd::First), std::pair(bar.right(), SpanEnd::Last)}) {
      const double away = std::abs(position.x() - x);
      if (away > least) continue;
      least = away;
      nearest = Handle{i, end};
    }
  }
  return nearest;
}

int ContactStrip::contactAt(const QPointF& position) const {
  for (int i = 0; i < static_cast<int>(contacts_.size()); ++i)
    if (barOf(contacts_[static_cast<std::size_t>(i)]).contains(position)) return i;
  return -1;
}

int ContactStrip::laneAt(double y) const {
  for (const int landmark : lanes_) {
    const QRectF lane = barOf({landmark, 0, std::max(frames_ - 1, 0)});
    if (y >= lane.top() && y <= lane.bottom()) return landmark;
  }
  return -1;
}

QRectF ContactStrip::barOf(const ContactSpan& span) const {
  const auto lane = std::find(lanes_.begin(), lanes_.end(), span.landmark) - lanes_.begin();
  const double left = axis().xOf(span.first_frame);
  const double top = kLaneGap + 2 + static_cast<double>(lane) * (kLaneHeight + kLaneGap);
  return {left, top, std::max(axis().xOf(span.last_frame + 1) - left, 1.0), kLaneHeight};
}

double ContactStrip::slideOf(const ContactSpan& span) const {
  const auto found = std::find_if(findings_.begin(), findings_.end(),
                                  [&](const SlideFinding& slide) { return slide.span == span; });
  return found == findings_.end() ? 0 : found->drift_cm;
}

QString ContactStrip::describe(const ContactSpan& span) const {
  return tr("%1 stands in frames %L2–%L3 and drifts by %4 from the original. Drag an end to move "
            "it.")
      .arg(names_[static_cast<std::size_t>(span.landmark)])
      .arg(span.first_frame + 1)
      .arg(span.last_frame + 1)
      .arg(lengthText(slideOf(span)));
}

void ContactStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const TimeAxis time = axis();
  const QRectF plot(time.left, 0, time.right - time.left, height());
  for (const int landmark : lanes_) {
    const QRectF lane = barOf({landmark, 0, std::max(frames_ - 1, 0)});
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(QRectF(kStripMargin, lane.top(), label_width_, lane.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, names_[static_cast<std::size_t>(landmark)]);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawRoundedRect(lane.intersected(plot), kCorner, kCorner);
  }
  painter.setClipRect(plot);
  painter.setPen(Qt::NoPen);
  for (const ContactSpan& span : contacts_) {
    painter.setBrush(slideColour(slideOf(span)));
    painter.drawRoundedRect(barOf(span), kCorner, kCorner);
  }
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = axis().xOf(frame_ + 0.5);
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
  if (event->button() != Qt::LeftButton) return;
  dragged_ = handleAt(event->position());
  before_drag_ = contacts_;
  if (!dragged_) emit seekRequested(axis().frameAt(event->position().x()));
}

void ContactStrip::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (!(event->buttons() & Qt::LeftButton)) {
    handleAt(event->position()) ? setCursor(Qt::SplitHCursor) : unsetCursor();
    return;
  }
  if (!dragged_) return emit seekRequested(axis().frameAt(x));
  // Contacts end between frames, so the end moves to the frame boundary nearest to the mouse.
  const double half_frame = (axis().xOf(1) - axis().xOf(0)) / 2;
  const int frame = dragged_->end == SpanEnd::First ? axis().frameAt(x + half_frame)
                                                    : axis().frameAt(x - half_frame);
  contacts_ = withEndAt(before_drag_, dragged_->contact, dragged_->end, frame, frames_);
  update();
}

void ContactStrip::mouseReleaseEvent(QMouseEvent*) {
  if (!dragged_) return;
  dragged_.reset();
  if (contacts_ != before_drag_) emit contactsEdited(contacts_);
}

void ContactStrip::contextMenuEvent(QContextMenuEvent* event) {
  const int contact = contactAt(event->pos());
  const int landmark = laneAt(event->pos().y());
  if (landmark < 0) return event->ignore();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (contact >= 0)
    menu->addAction(tr("Remove Contact"), this,
                    [=, this] { emit contactsEdited(withoutContact(contacts_, contact)); });
  else
    menu->addAction(tr("Add Contact Here"), this, [=, this, x = event->pos().x()] {
      emit contactsEdited(
          withContactAt(contacts_, landmark, axis().frameAt(x), usual_length_, frames_));
    });
  menu->addSeparator();
  menu->addActions(actions());
  menu->popup(event->globalPos());
}

}  // namespace mocapress
