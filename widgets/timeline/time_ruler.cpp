// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/time_ruler.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

constexpr int kTick = 3;                  // pixels
constexpr int kCareHeight = 14;           // pixels
constexpr double kCareCorner = 2;         // pixels
constexpr double kEndReach = 5;           // pixels on both sides of the range's end
constexpr double kDrag = 3;               // pixels beyond which a press is a drag
constexpr double kApart = 1.6;            // least distance between numbers, in widths of a number
constexpr QRgb kCareColour = 0xff0072b2;  // Okabe and Ito's blue

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`.
double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0})
    if (times * power >= least * (1 - 1e-9)) return times * power;
  return 10 * power;
}

}  // namespace

TimeRuler::TimeRuler(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Time ruler"));
  setAccessibleDescription(tr("Frames and seconds. The menu Play chooses a range."));
  setMouseTracking(true);
}

void TimeRuler::setClip(int frames, double sample_rate_hz) {
  frames_ = frames;
  sample_rate_hz_ = sample_rate_hz;
  update();
}

void TimeRuler::setRange(const std::optional<FrameRange>& range) {
  range_ = range;
  update();
}

void TimeRuler::setCare(std::vector<ImportantRange> care) {
  const bool changes_height = care.empty() != care_.empty();
  care_ = std::move(care);
  if (changes_height) updateGeometry();
  update();
}

void TimeRuler::setFrame(int frame) {
  frame_ = frame;
  update();
}

void TimeRuler::setWindow(const FrameWindow& window) {
  window_ = window;
  update();
}

void TimeRuler::setLabelWidth(int pixels) {
  label_width_ = pixels;
  update();
}

int TimeRuler::labelWidth() const {
  return std::max({fontMetrics().horizontalAdvance(tr("Frame")),
                   fontMetrics().horizontalAdvance(tr("Seconds")),
                   fontMetrics().horizontalAdvance(tr("Care"))});
}

int TimeRuler::rowHeight() const {
  return fontMetrics().ascent() + kTick + 1;
}

QSize TimeRuler::sizeHint() const {
  return {200, 2 * rowHeight() + 2 + (care_.empty() ? 0 : kCareHeight + 2)};
}

TimeAxis TimeRuler::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

int TimeRuler::framesApart() const {
  const TimeAxis time = axis();
  const double widest = fontMetrics().horizontalAdvance(QString::number(std::max(frames_, 1)));
  const double pixels = std::max((time.right - time.left) / time.length(), 1e-6);
  return static_cast<int>(roundStep(std::max(kApart * widest / pixels, 1.0)));
}

void TimeRuler::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const TimeAxis time = axis();
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const auto label = [&](double top, double height, const QString& text) {
    painter.drawText(QRectF(kStripMargin, top, label_width_, height),
                     Qt::AlignLeft | Qt::AlignVCenter, text);
  };
  label(0, rowHeight(), tr("Frame"));
  label(rowHeight(), rowHeight(), tr("Seconds"));
  if (!care_.empty()) label(2 * rowHeight() + 2, kCareHeight, tr("Care"));
  if (frames_ == 0) return;
  painter.setClipRect(QRectF(time.left, 0, time.right - time.left, height()));
  if (range_) {
    QColor chosen = palette().color(QPalette::Highlight);
    chosen.setAlphaF(0.3F);
    const double from = time.xOf(range_->first);
    painter.fillRect(QRectF(from, 0, time.xOf(range_->second + 1) - from, height()), chosen);
  }
  paintFrames(painter);
  paintSeconds(painter);
  paintCare(painter);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  const double x = time.xOf(frame_ + 0.5);
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

/// Draws frame numbers, which begin at 1 as everywhere in the studio.
void TimeRuler::paintFrames(QPainter& painter) const {
  const TimeAxis time = axis();
  const int apart = framesApart();
  const int end = std::min(frames_, static_cast<int>(window_.first + time.length()) + 1);
  painter.setPen(palette().color(QPalette::WindowText));
  const auto mark = [&](int number) {
    const double x = time.xOf(number - 0.5);
    if (x < time.left) return;  // else the number would be cut
    painter.drawLine(QPointF(x, rowHeight() - kTick), QPointF(x, rowHeight()));
    const QString text = locale().toString(number);
    if (x + 2 + fontMetrics().horizontalAdvance(text) <= time.right)  // else it would be cut
      painter.drawText(QRectF(x + 2, 0, 100, rowHeight() - 1), Qt::AlignLeft | Qt::AlignTop, text);
  };
  if (apart > 1 && window_.first < 1) mark(1);
  const int first = static_cast<int>(window_.first) / apart * apart;
  for (int number = std::max(first, apart); number <= end; number += apart) mark(number);
}

void TimeRuler::paintSeconds(QPainter& painter) const {
  const TimeAxis time = axis();
  const double pixels = (time.right - time.left) / time.length() * sample_rate_hz_;  // per second
  const double apart =
      roundStep(kApart * fontMetrics().horizontalAdvance(QStringLiteral("00.00")) / pixels);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(apart) + 1e-9)));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const double end = (window_.first + time.length()) / sample_rate_hz_;
  for (double at = std::ceil(window_.first / sample_rate_hz_ / apart); at * apart <= end; ++at) {
    const double x = time.xOf(at * apart * sample_rate_hz_ + 0.5);
    painter.drawLine(QPointF(x, rowHeight()), QPointF(x, rowHeight() + kTick));
    const QString text = locale().toString(at * apart, 'f', decimals);
    if (x + 2 + fontMetrics().horizontalAdvance(text) <= time.right)
      painter.drawText(QRectF(x + 2, rowHeight(), 100, rowHeight()),
                       Qt::AlignLeft | Qt::AlignVCenter, text);
  }
}

QRectF TimeRuler::barOf(const ImportantRange& care) const {
  const double from = axis().xOf(care.first_frame);
  return {from, 2.0 * rowHeight() + 2, std::max(axis().xOf(care.last_frame + 1) - from, 1.0),
          kCareHeight};
}

void TimeRuler::paintCare(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const ImportantRange& care : care_) {
    const QRectF bar = barOf(care);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(kCareColour));
    painter.drawRoundedRect(bar, kCareCorner, kCareCorner);
    painter.setPen(Qt::white);
    painter.drawText(bar.adjusted(3, 0, -3, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     QStringLiteral("× ") + locale().toString(care.factor, 'g', 3));
  }
}

const ImportantRange* TimeRuler::careAt(const QPointF& position) const {
  for (const ImportantRange& care : care_)
    if (barOf(care).contains(position)) return &care;
  return nullptr;
}

std::optional<int> TimeRuler::endAt(double x) const {
  if (!range_) return {};
  if (std::abs(axis().xOf(range_->first) - x) <= kEndReach) return range_->second;
  if (std::abs(axis().xOf(range_->second + 1) - x) <= kEndReach) return range_->first;
  return {};
}

QString TimeRuler::describe(const ImportantRange& care) const {
  return tr("Frames %L1–%L2: the target is %L3 times stricter. A click chooses the range.")
      .arg(care.first_frame + 1)
      .arg(care.last_frame + 1)
      .arg(care.factor, 0, 'g', 3);
}

bool TimeRuler::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const ImportantRange* const care = careAt(help->pos());
  QString text = tr("Drag to choose a range, then right-click it.");
  if (range_)
    text = tr("Frames %L1–%L2, %3. A double click chooses the whole clip again.")
               .arg(range_->first + 1)
               .arg(range_->second + 1)
               .arg(tr("%1 s").arg(locale().toString(
                   (range_->second - range_->first + 1) / sample_rate_hz_, 'f', 2)));
  QToolTip::showText(help->globalPos(), care ? describe(*care) : text, this);
  return true;
}

void TimeRuler::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || frames_ == 0) return;
  pressed_x_ = event->position().x();
  drags_ = false;
  range_from_ = endAt(pressed_x_).value_or(axis().frameAt(pressed_x_));
}

void TimeRuler::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (!(event->buttons() & Qt::LeftButton)) {
    endAt(x) ? setCursor(Qt::SplitHCursor) : unsetCursor();
    return;
  }
  drags_ = drags_ || std::abs(x - pressed_x_) > kDrag;
  const int frame = axis().frameAt(x);
  if (drags_ && frames_ > 0 && frame != range_from_)
    emit rangeChosen(FrameRange(std::minmax(frame, range_from_)));
}

void TimeRuler::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || drags_ || frames_ == 0) return;
  if (const ImportantRange* const care = careAt(event->position()))
    emit rangeChosen(FrameRange(care->first_frame, care->last_frame));
  emit seekRequested(axis().frameAt(event->position().x()));
}

void TimeRuler::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit rangeChosen(std::nullopt);
}

void TimeRuler::contextMenuEvent(QContextMenuEvent* event) {
  if (const ImportantRange* const care = careAt(event->pos()))
    emit rangeChosen(FrameRange(care->first_frame, care->last_frame));
  if (actions().isEmpty()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addActions(actions());
  menu->popup(event->globalPos());
}

}  // namespace mocapress
