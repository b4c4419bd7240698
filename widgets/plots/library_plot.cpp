// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/library_plot.h"

#include <qcustomplot.h>

#include <QToolTip>
#include <QVBoxLayout>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/models/library_filter.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

constexpr auto kRedrawInterval = std::chrono::milliseconds(100);
constexpr QSize kLeastPlot(180, 110);
constexpr double kPointReach = 10;  // px between a point and a click that chooses it
constexpr int kClickReach = 4;      // px that the mouse may move during a click

/// Draws the points of a graph as copies of one picture: filling thousands of circles takes longer
/// than a frame lasts.
class PointGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawScatterPlot(QCPPainter* painter, const QVector<QPointF>& points,
                       const QCPScatterStyle& style) const override {
    const double pixels = parentPlot()->bufferDevicePixelRatio();
    const int half = qCeil(style.size() / 2 + style.pen().widthF());
    QPixmap picture(QSize(2 * half, 2 * half) * pixels);
    picture.setDevicePixelRatio(pixels);
    picture.fill(Qt::transparent);
    QCPPainter one(&picture);
    applyScattersAntialiasingHint(&one);
    style.applyTo(&one, pen());
    style.drawShape(&one, half, half);
    for (const QPointF& point : points) painter->drawPixmap(point - QPointF(half, half), picture);
  }
};

bool isShown(const LibraryEntry& entry) {
  return entry.outcome && entry.outcome->ratio > 0 && entry.outcome->eps_cm > 0;
}

}  // namespace

LibraryPlot::LibraryPlot(const LibraryFilter* clips, QWidget* parent)
    : QWidget(parent), clips_(clips), plot_(new QCustomPlot(this)), hint_(new QCPItemText(plot_)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  offerCopyImage(this);
  plot_->setAccessibleName(tr("Clips of the library, error over ratio"));
  plot_->setAccessibleDescription(tr("The columns of the library show all measurements."));
  plot_->xAxis->setLabel(tr("Compression ratio (smaller files →)"));
  plot_->yAxis->setLabel(tr("eps_x (cm)"));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setScaleType(QCPAxis::stLogarithmic);
  plot_->xAxis->setTicker(QSharedPointer<LogTicker>::create(QStringLiteral(":1")));
  plot_->yAxis->setTicker(QSharedPointer<LogTicker>::create());
  plot_->setInteractions(QCP::iRangeZoom | QCP::iRangeDrag);
  // The legend is above the axes: within them it would cover clips.
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->addElement(0, 0, plot_->legend);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  plot_->setMinimumSize(kLeastPlot);          // else the legend's width would be the minimum
  plot_->axisRect()->setMinimumSize(50, 15);  // in a low panel the points shrink, not the axis
  plot_->legend->setIconSize(10, fontMetrics().height());
  hint_->position->setType(QCPItemPosition::ptAxisRectRatio);
  hint_->position->setCoords(0.5, 0.5);
  hint_->setText(tr("Clips appear here after they are compressed"));
  redraw_later_.setSingleShot(true);
  redraw_later_.setInterval(kRedrawInterval);
  connect(&redraw_later_, &QTimer::timeout, this, &LibraryPlot::redraw);
  connect(clips, &LibraryFilter::modelReset, this, &LibraryPlot::redrawSoon);
  connect(clips, &LibraryFilter::rowsInserted, this, &LibraryPlot::redrawSoon);
  connect(clips, &LibraryFilter::rowsRemoved, this, &LibraryPlot::redrawSoon);
  connect(clips, &LibraryFilter::dataChanged, this, &LibraryPlot::redrawSoon);
  connectMouse();
  redraw();
}

void LibraryPlot::connectMouse() {
  connect(plot_, &QCustomPlot::mousePress, this,
          [this](const QMouseEvent* event) { pressed_at_ = event->pos(); });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton)
      hover(event->pos());
    else
      moved_ = true;
  });
  connect(plot_, &QCustomPlot::mouseRelease, this, [this](const QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    if ((event->pos() - pressed_at_).manhattanLength() > kClickReach) return;
    if (const int clip = clipAt(event->pos()); clip >= 0) emit openRequested(clip);
  });
  connect(plot_, &QCustomPlot::mouseWheel, this, [this] { moved_ = true; });
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this](const QMouseEvent* event) {
    if (clipAt(event->pos()) >= 0) return;
    moved_ = false;
    showAll();
    plot_->replot(QCustomPlot::rpQueuedReplot);
  });
}

void LibraryPlot::setCurrent(int clip) {
  current_ = clip;
  placeRing();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LibraryPlot::redrawSoon() {
  if (isVisible() && !redraw_later_.isActive()) redraw_later_.start();
}

void LibraryPlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  redraw();
}

void LibraryPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw();
}

/// Draws one graph for each class of visibility, and one for clips that were not judged.
void LibraryPlot::redraw() {
  applyPalette(plot_);
  const QColor text = palette().color(QPalette::Text);
  plot_->clearGraphs();
  const auto add = [&](const QString& name, const QColor& colour) {
    QCPGraph* graph = new PointGraph(plot_->xAxis, plot_->yAxis);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(
        {QCPScatterStyle::ssCircle, QPen(colour, 1.2), QBrush(fainter(colour, 0.45F)), 7});
    graph->setName(name);
    return graph;
  };
  QCPGraph* unseen = add(tr("not known"), fainter(text, 0.5F));
  std::array<QCPGraph*, 3> seen{};
  for (const Sight sight : {Sight::NotVisible, Sight::Borderline, Sight::Visible})
    seen[static_cast<std::size_t>(sight)] = add(displayName(sight), sightColour(sight));
  for (int row = 0; row < clips_->rowCount(); ++row) {
    const LibraryEntry& entry = clips_->entry(row);
    if (!isShown(entry)) continue;
    const std::optional<Sight>& sight = entry.outcome->sight;
    (sight ? seen[static_cast<std::size_t>(*sight)] : unseen)
        ->addData(entry.outcome->ratio, entry.outcome->eps_cm);
  }
  bool any = false;
  for (int i = 0; i < plot_->graphCount(); ++i) {
    if (plot_->graph(i)->data()->isEmpty())
      plot_->graph(i)->removeFromLegend();
    else
      any = true;
  }
  plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);  // lays out the new items
  plot_->legend->setVisible(any);
  plot_->legend->setBrush(Qt::NoBrush);
  plot_->legend->setBorderPen(Qt::NoPen);
  plot_->legend->setTextColor(text);
  plot_->legend->setFont(font());
  hint_->setVisible(!any);
  hint_->setColor(fainter(text, 0.6F));
  hint_->setFont(font());
  ring_ = plot_->addGraph();
  ring_->setLineStyle(QCPGraph::lsNone);
  ring_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(text, 1.8), Qt::NoBrush, 15});
  ring_->removeFromLegend();
  placeRing();
  if (!moved_) showAll();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LibraryPlot::placeRing() {
  ring_->data()->clear();
  const int row = current_ >= 0 ? clips_->rowOf(current_) : -1;
  if (row < 0 || !isShown(clips_->entry(row))) return;
  const Outcome& outcome = *clips_->entry(row).outcome;
  ring_->addData(outcome.ratio, outcome.eps_cm);
}

void LibraryPlot::showAll() {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // Unlike a QCPRange, this range can be empty.
  struct Range {
    double lower = kInfinity, upper = 0;
    void include(double value) {
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
  };
  Range ratios, errors;
  for (int row = 0; row < clips_->rowCount(); ++row) {
    const LibraryEntry& entry = clips_->entry(row);
    if (!isShown(entry)) continue;
    ratios.include(entry.outcome->ratio);
    errors.include(entry.outcome->eps_cm);
  }
  if (!(ratios.upper > 0)) ratios = {5, 200}, errors = {0.05, 3};
  plot_->xAxis->setRange(ratios.lower / 1.2, ratios.upper * 1.2);
  plot_->yAxis->setRange(errors.lower / 1.4, errors.upper * 1.4);
}

QPoint LibraryPlot::positionOf(int clip) const {
  const Outcome& outcome = *clips_->entry(clips_->rowOf(clip)).outcome;
  const QPointF position(plot_->xAxis->coordToPixel(outcome.ratio),
                         plot_->yAxis->coordToPixel(outcome.eps_cm));
  return plot_->mapTo(this, position.toPoint());
}

int LibraryPlot::clipAt(const QPoint& position) const {
  int nearest = -1;
  double least = kPointReach;
  for (int row = 0; row < clips_->rowCount(); ++row) {
    const LibraryEntry& entry = clips_->entry(row);
    if (!isShown(entry)) continue;
    const double distance =
        std::hypot(plot_->xAxis->coordToPixel(entry.outcome->ratio) - position.x(),
                   plot_->yAxis->coordToPixel(entry.outcome->eps_cm) - position.y());
    if (distance > least) continue;
    least = distance;
    nearest = clips_->clipAt(row);
  }
  return nearest;
}

void LibraryPlot::hover(const QPoint& position) {
  const int clip = clipAt(position);
  plot_->setCursor(clip >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (clip < 0) return QToolTip::hideText();
  QToolTip::showText(plot_->mapToGlobal(position + QPoint(12, 12)),
                     clips_->index(clips_->rowOf(clip), 0).data(Qt::AccessibleTextRole).toString(),
                     plot_);
}

}  // namespace mocapress
