// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/error_strip.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/models/number_text.h"

namespace mocapress {
namespace {

constexpr int kAbove = 9;  // pixels above the plot, for the marks
constexpr int kBelow = 2;
constexpr double kMarkSize = 7;
constexpr int kRampWidth = 5;
constexpr int kRampGap = 4;
constexpr QRgb kMark = 0xffd55e00;  // Okabe and Ito's vermilion

}  // namespace

ErrorStrip::ErrorStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Error strip"));
  setAccessibleDescription(
      tr("Largest and mean error at every frame. The table of joints has the numbers."));
}

void ErrorStrip::setErrors(ErrorProfile profile, const ErrorScale& scale, int frames) {
  profile_ = std::move(profile);
  scale_ = scale;
  frames_ = frames;
  showErrors();
}

void ErrorStrip::showErrors() {
  errors_ = QPixmap();
  update();
}

void ErrorStrip::resizeEvent(QResizeEvent*) {
  showErrors();
}

void ErrorStrip::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showErrors();
}

void ErrorStrip::setGlitches(std::vector<Glitch> glitches, std::vector<QString> names) {
  glitches_ = std::move(glitches);
  names_ = std::move(names);
  update();
}

void ErrorStrip::setRange(const std::optional<FrameRange>& range) {
  range_ = range;
  update();
}

void ErrorStrip::setFrame(int frame) {
  frame_ = frame;
  update();
}

void ErrorStrip::setLabelWidth(int pixels) {
  if (pixels == label_width_) return;
  label_width_ = pixels;
  showErrors();
}

/// Leaves room for every scale, so that the strip does not move when another scale is chosen.
int ErrorStrip::labelWidth() const {
  int widest = 0;
  for (const double top : errorScales(scale_.quantity))
    widest =
        std::max(widest, fontMetrics().horizontalAdvance(roundErrorText(top, scale_.quantity)));
  return fontMetrics().horizontalAdvance(tr("Error") + QStringLiteral("  ")) + widest + kRampGap +
         kRampWidth;
}

TimeAxis ErrorStrip::axis() const {
  return {static_cast<double>(2 * kStripMargin + label_width_),
          static_cast<double>(width() - kStripMargin), frames_, window_};
}

void ErrorStrip::setWindow(const FrameWindow& window) {
  if (window == window_) return;
  window_ = window;
  showErrors();
}

QRectF ErrorStrip::plotArea() const {
  const TimeAxis time = axis();
  return {time.left, kAbove, time.right - time.left,
          static_cast<double>(height() - kAbove - kBelow)};
}

void ErrorStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF area = plotArea();
  painter.fillRect(area, palette().color(QPalette::AlternateBase));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const QRectF label(kStripMargin, area.top(), label_width_, area.height());
  painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, tr("Error"));
  paintScale(painter);
  painter.setClipRect(area.adjusted(0, -kAbove, 0, kBelow));
  if (profile_.frames() == frames_ && frames_ > 0) {
    if (errors_.isNull() || errors_.devicePixelRatio() != devicePixelRatioF())
      errors_ = paintedErrors();
    painter.drawPixmap(0, 0, errors_);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGlitches(painter);
  }
  paintRange(painter);
  const double x = axis().xOf(frame_ + 0.5);
  painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
}

/// Draws the scale, which explains the heights and colours of the columns.
void ErrorStrip::paintScale(QPainter& painter) const {
  const QRectF area = plotArea();
  const double right = area.left() - kStripMargin;
  for (double y = 0; y < area.height(); ++y)
    painter.fillRect(QRectF(right - kRampWidth, area.bottom() - y - 1, kRampWidth, 1),
                     viridis(y / (area.height() - 1)));
  painter.setPen(palette().color(QPalette::WindowText));
  // The number at the top may reach a little above the plot.
  const double line = fontMetrics().height();
  const QRectF numbers(kStripMargin, area.top() - line / 4,
                       right - kRampWidth - kRampGap - kStripMargin,
                       area.height() + line / 4 + kBelow);
  painter.drawText(numbers, Qt::AlignRight | Qt::AlignTop,
                   roundErrorText(scale_.top, scale_.quantity));
  painter.drawText(numbers, Qt::AlignRight | Qt::AlignBottom, QStringLiteral("0"));
}

QPixmap ErrorStrip::paintedErrors() const {
  QPixmap picture(size() * devicePixelRatioF());
  picture.setDevicePixelRatio(devicePixelRatioF());
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  paintColumns(painter);
  paintMean(painter);
  return picture;
}

/// Draws a column for each pixel with the maximum of its frames, so that no peak is lost.
void ErrorStrip::paintColumns(QPainter& painter) const {
  const QRectF area = plotArea();
  const TimeAxis time = axis();
  for (double x = area.left(); x < area.right(); ++x) {
    const int first = time.frameAt(x);
    const int count = std::max(1, time.frameAt(x + 1) - first);
    const auto cm = static_cast<double>(profile_.max.segment(first, count).maxCoeff());
    const double height = std::max(1.0, scale_.share(cm) * area.height());
    painter.fillRect(QRectF(x, area.bottom() - height, 1, height), scale_.colour(cm));
  }
}

/// Draws the line pixel by pixel: a smooth line of this length would take ten times as long.
void ErrorStrip::paintMean(QPainter& painter) const {
  const QRectF area = plotArea();
  const TimeAxis time = axis();
  std::vector<QRectF> line;
  double before = -1;
  for (double x = area.left(); x < area.right(); ++x) {
    const auto cm = static_cast<double>(profile_.mean[time.frameAt(x)]);
    const double y = std::round(area.bottom() - scale_.share(cm) * area.height());
    const double from = before < 0 ? y : std::min(y, before);
    line.emplace_back(x, from, 1, std::max(y, before) - from + 1);
    before = y;
  }
  // The columns are dark at the bottom and lighter above: a light line with a dark rim is visible
  // on both.
  for (const QRectF& piece : line)
    painter.fillRect(piece.adjusted(0, -1, 0, 1), QColor(0, 0, 0, 130));
  for (const QRectF& piece : line) painter.fillRect(piece, Qt::white);
}

void ErrorStrip::paintGlitches(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(kMark));
  for (const Glitch& glitch : glitches_) {
    const double x = axis().xOf(glitch.frame + 0.5);
    painter.drawPolygon(
        QPolygonF({{x - kMarkSize / 2, 1.0}, {x + kMarkSize / 2, 1.0}, {x, 1.0 + kMarkSize}}));
  }
}

void ErrorStrip::paintRange(QPainter& painter) const {
  if (!range_) return;
  const QRectF area = plotArea();
  const double from = axis().xOf(range_->first);
  const double to = axis().xOf(range_->second + 1);
  QColor veil = palette().color(QPalette::Window);
  veil.setAlphaF(0.7F);
  painter.fillRect(QRectF(area.left(), 0, from - area.left(), height()), veil);
  painter.fillRect(QRectF(to, 0, area.right() - to, height()), veil);
  painter.fillRect(QRectF(from, 0, to - from, 3), palette().color(QPalette::Highlight));
}

bool ErrorStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text =
      help->pos().x() < axis().left
          ? tr("Errors of this size or more have full height and the lightest colour. Click to "
               "choose another scale.")
          : tr("Largest error at every frame as a column, mean error as a line. Turn the wheel to "
               "zoom, with Shift to scroll; drag with Shift to choose the range to play.");
  for (const Glitch& glitch : glitches_)
    if (std::abs(axis().xOf(glitch.frame + 0.5) - help->pos().x()) < kMarkSize &&
        help->pos().y() < 2 * kAbove)
      text = tr("A jump of one frame: %1 at frame %L2, %3")
                 .arg(names_[static_cast<std::size_t>(glitch.landmark)])
                 .arg(glitch.frame + 1)
                 .arg(lengthText(glitch.cm));
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void ErrorStrip::pointAt(double x, bool chooses_range) {
  const int frame = axis().frameAt(x);
  if (!chooses_range) return emit seekRequested(frame);
  if (frame != range_from_) emit rangeChosen(std::minmax(frame, range_from_));
}

void ErrorStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (event->position().x() < axis().left) return showMenu(event->globalPosition().toPoint());
  range_from_ = axis().frameAt(event->position().x());
  pointAt(event->position().x(), event->modifiers() & Qt::ShiftModifier);
}

void ErrorStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    pointAt(event->position().x(), event->modifiers() & Qt::ShiftModifier);
}

/// Opens the scale's own menu. Beside the scale, the timeline opens its menu.
void ErrorStrip::contextMenuEvent(QContextMenuEvent* event) {
  if (event->pos().x() >= axis().left) return event->ignore();
  showMenu(event->globalPos());
}

void ErrorStrip::showMenu(const QPoint& global) {
  if (actions().isEmpty()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addActions(actions());
  menu->popup(global);
}

}  // namespace mocapress
