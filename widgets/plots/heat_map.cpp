// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/heat_map.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "widgets/models/colours.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

constexpr int kMostColumns = 2048;
constexpr int kMargin = 8;
constexpr int kLegendHeight = 22;
constexpr int kRampWidth = 140;

std::array<QRgb, 256> ramp() {
  std::array<QRgb, 256> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = viridis(static_cast<double>(i) / (colours.size() - 1)).rgb();
  return colours;
}

/// Makes a picture with a row for each landmark or joint and a column for each group of frames.
/// `colour(row, first, last)` gives the colour of one cell.
template <typename Colour>
QImage paintedCells(int frames, int rows, int most_columns, const Colour& colour) {
  if (frames == 0 || rows == 0) return {};
  const std::int64_t columns = std::min(frames, most_columns);
  QImage image(static_cast<int>(columns), rows, QImage::Format_RGB32);
  for (int row = 0; row < rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (std::int64_t column = 0; column < columns; ++column) {
      const auto first = static_cast<int>(column * frames / columns);
      const auto end = static_cast<int>((column + 1) * frames / columns);
      line[column] = colour(row, first, std::max(end - 1, first));
    }
  }
  return image;
}

}  // namespace

QImage heatImage(const Eigen::MatrixXf& errors, const ErrorScale& scale, int most_columns) {
  static const std::array<QRgb, 256> kRamp = ramp();
  return paintedCells(
      static_cast<int>(errors.rows()), static_cast<int>(errors.cols()), most_columns,
      [&](int row, int first, int last) {
        const auto worst =
            static_cast<double>(errors.col(row).segment(first, last - first + 1).maxCoeff());
        return kRamp[static_cast<std::size_t>(std::lround(255 * scale.share(worst)))];
      });
}

QImage sightImage(const SightTable& sight, int frames, int most_columns) {
  return paintedCells(
      frames, static_cast<int>(sight.times_noticed.cols()), most_columns,
      [&](int row, int first, int last) {
        const int window = sight.window_of(first);
        const int count = sight.window_of(last) - window + 1;
        return sightColour(static_cast<double>(
                               sight.times_noticed.col(row).segment(window, count).maxCoeff()))
            .rgb();
      });
}

HeatMap::HeatMap(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Heat map of errors"));
  setAccessibleDescription(
      tr("Error of every joint at every frame. Arrow keys move to the next joint or frame."));
  setFocusPolicy(Qt::StrongFocus);
  offerCopyImage(this);
}

void HeatMap::setErrors(ErrorsPtr errors, std::vector<QString> names, const ErrorScale& scale) {
  errors_ = std::move(errors);
  names_ = std::move(names);
  scale_ = scale;
  image_ = QImage();  // painted again when needed
  names_width_ = 0;
  const QFontMetrics widest(boldFont());
  for (const QString& name : names_)
    names_width_ = std::max(names_width_, widest.horizontalAdvance(name));
  update();
}

QFont HeatMap::boldFont() const {
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  return bold;
}

void HeatMap::setSight(SightPtr sight, bool shown) {
  sight_ = std::move(sight);
  sight_shown_ = shown;
  image_ = QImage();
  update();
}

void HeatMap::setSwitches(const QList<QAction*>& actions) {
  qDeleteAll(switches_);
  switches_.clear();
  for (QAction* action : actions) switches_.push_back(new SwitchButton(action, this));
  placeSwitches();
}

/// Puts the switches below the names, to the left of the legend.
void HeatMap::placeSwitches() {
  int left = kMargin;
  for (SwitchButton* button : switches_) {
    const QSize size(button->sizeHint().width(), kLegendHeight - 2);
    button->setGeometry({{left, height() - size.height() - 1}, size});
    left += size.width() + 2;
  }
}

void HeatMap::resizeEvent(QResizeEvent*) {
  placeSwitches();
}

const Eigen::MatrixXf& HeatMap::shown() const {
  static const Eigen::MatrixXf kUnknown;
  return errors_ ? errorsOver(*errors_, scale_.quantity) : kUnknown;
}

void HeatMap::setFrame(int frame) {
  frame_ = frame;
  update();
}

void HeatMap::setCurrentLandmark(int landmark) {
  current_ = landmark;
  update();
}

QRectF HeatMap::mapArea() const {
  const double left = 2 * kMargin + names_width_;
  return {left, kMargin / 2.0, width() - left - kMargin, height() - kMargin / 2.0 - kLegendHeight};
}

QRectF HeatMap::rowOf(int landmark) const {
  const QRectF area = mapArea();
  const double height = area.height() / std::max(rows(), 1);
  return {area.left(), area.top() + landmark * height, area.width(), height};
}

std::optional<HeatMap::Cell> HeatMap::cellAt(const QPointF& position) const {
  const QRectF area = mapArea();
  if (shown().size() == 0) return {};
  const auto place = [](double share, int count) {
    return std::clamp(static_cast<int>(std::floor(share * count)), 0, count - 1);
  };
  return Cell{place((position.x() - area.left()) / area.width(), frames()),
              place((position.y() - area.top()) / area.height(), rows())};
}

void HeatMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRectF area = mapArea();
  if (image_.isNull()) image_ = paintedImage();
  if (image_.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter, tr("Errors are measured against the original."));
    return;
  }
  painter.drawImage(area, image_);
  painter.setPen(palette().color(QPalette::Text));
  // Omits names that would overlap, but never the current one.
  const int line = fontMetrics().height();
  const int step = std::max(1, static_cast<int>(std::ceil(line / rowOf(0).height())));
  const auto name = [&](int row) {
    const QRectF at = rowOf(row);
    const double top = std::min(at.center().y() - line / 2.0, area.bottom() - line);
    painter.drawText(QRectF(kMargin, std::max(top, 0.0), names_width_, line),
                     Qt::AlignRight | Qt::AlignVCenter, names_[static_cast<std::size_t>(row)]);
  };
  for (int row = 0; row < rows(); row += step)
    if (current_ < 0 || std::abs(row - current_) >= step) name(row);
  const double x = area.left() + area.width() * (frame_ + 0.5) / std::max(1, frames());
  painter.setPen(QPen(Qt::white, 1));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  if (current_ >= 0 && current_ < rows()) {
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(boldFont());
    name(current_);
    painter.setFont(font());
    painter.setPen(QPen(Qt::white, 1));
    painter.drawRect(rowOf(current_).adjusted(0, -0.5, 0, 0.5));
  }
  showsSight() ? paintVerdicts(painter) : paintLegend(painter);
}

QImage HeatMap::paintedImage() const {
  return showsSight() ? sightImage(*sight_, frames(), kMostColumns)
                      : heatImage(shown(), scale_, kMostColumns);
}

void HeatMap::paintLegend(QPainter& painter) const {
  const QRectF area = mapArea();
  const QString none = QStringLiteral("0");
  const QString top = QStringLiteral("≥ %1").arg(roundErrorText(scale_.top, scale_.quantity));
  const double top_width = fontMetrics().horizontalAdvance(top) + 4;
  const double y = area.bottom() + kLegendHeight / 2.0 + 1;
  const double left = area.right() - top_width - kRampWidth - 6;
  for (int x = 0; x < kRampWidth; ++x)
    painter.fillRect(QRectF(left + x, y - 4, 1, 8),
                     viridis(static_cast<double>(x) / (kRampWidth - 1)));
  painter.setPen(palette().color(QPalette::Text));
  const double line = fontMetrics().height();
  painter.drawText(QRectF(area.right() - top_width, y - line / 2, top_width, line),
                   Qt::AlignRight | Qt::AlignVCenter, top);
  painter.drawText(QRectF(left - 106, y - line / 2, 100, line), Qt::AlignRight | Qt::AlignVCenter,
                   none);
}

/// Draws the legend of visibility, from the right until it would reach the switches.
void HeatMap::paintVerdicts(QPainter& painter) const {
  const QRectF area = mapArea();
  const double y = area.bottom() + kLegendHeight / 2.0 + 1;
  const double line = fontMetrics().height();
  double right = area.right();
  for (const auto& [sight, beyond] : {std::pair(Sight::Visible, QStringLiteral(" >2×")),
                                      std::pair(Sight::Borderline, QStringLiteral(" >1×")),
                                      std::pair(Sight::NotVisible, QString())}) {
    const QString text = displayName(sight) + beyond;
    const double width = fontMetrics().horizontalAdvance(text) + 2;
    const double left = right - width - 12;
    if (!switches_.empty() && left <= switches_.back()->geometry().right()) break;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(right - width, y - line / 2, width, line),
                     Qt::AlignRight | Qt::AlignVCenter, text);
    painter.fillRect(QRectF(left, y - 5, 10, 10), sightColour(sight));
    right = left - 6;
  }
}

bool HeatMap::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const std::optional<Cell> cell = cellAt(help->pos());
  if (!cell || !mapArea().contains(help->pos())) {
    QToolTip::hideText();
    return true;
  }
  QToolTip::showText(help->globalPos(), describe(*cell), this);
  return true;
}

QString HeatMap::describe(const Cell& cell) const {
  const QString errors = tr("%1, frame %L2: %3")
                             .arg(names_[static_cast<std::size_t>(cell.landmark)])
                             .arg(cell.frame + 1)
                             .arg(errorsText(*errors_, cell.frame, cell.landmark));
  // The first landmarks are the joints, which have visibility; the ends of bones come after them.
  if (!sight_ || cell.landmark >= sight_->times_noticed.cols()) return errors;
  return errors + QLatin1Char('\n') + sightText(sight_->at(cell.frame, cell.landmark));
}

void HeatMap::choose(const QPointF& position) {
  if (const std::optional<Cell> cell = cellAt(position)) emit chosen(cell->frame, cell->landmark);
}

void HeatMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position());
}

void HeatMap::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) choose(event->position());
}

void HeatMap::keyPressEvent(QKeyEvent* event) {
  const int down = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  if (down == 0 || rows() == 0) return QWidget::keyPressEvent(event);
  emit chosen(frame_, std::clamp(current_ + down, 0, rows() - 1));
}

}  // namespace mocapress
