// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/error_graph.h"

#include <qcustomplot.h>

#include <QHelpEvent>
#include <QTimer>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

constexpr int kSwitchMargin = 4;
constexpr QSize kLeastSize = {120, 80};
constexpr int kRoomy = 170;  // least height in pixels for a legend of several lines

}  // namespace

ErrorGraph::ErrorGraph(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  offerCopyImage(this);
  plot_->setAccessibleName(tr("Error over time"));
  plot_->setToolTip(
      tr("World-space distance or angle between joints and the original. Click to go to a frame, "
         "turn the wheel to zoom, double-click to show all."));
  plot_->axisRect()->setRangeZoom(Qt::Horizontal);
  plot_->setInteraction(QCP::iRangeZoom);
  // The curves have thousands of points: antialiasing would take longer than the 3D picture.
  plot_->setNotAntialiasedElements(QCP::aePlottables | QCP::aeFills);

  // The legend is above the curves, in as few lines as possible.
  auto* above = new QCPLayoutGrid;
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->addElement(0, 0, above);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  above->addElement(0, 0, plot_->legend);
  beside_legend_ = new QCPLayoutElement;
  above->addElement(0, 1, beside_legend_);
  above->setColumnStretchFactor(0, 0.001);
  plot_->legend->setBorderPen(Qt::NoPen);
  plot_->legend->setIconSize(14, 8);
  plot_->legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
  plot_->legend->setColumnSpacing(14);
  plot_->setMinimumSize(kLeastSize);          // else the legend's minimum would apply
  plot_->axisRect()->setMinimumSize(50, 15);  // in a low panel the curves shrink, not the legend

  // The playhead has a layer of its own, so that moving it does not redraw the curves.
  plot_->addLayer(QStringLiteral("playhead"));
  plot_->layer(QStringLiteral("playhead"))->setMode(QCPLayer::lmBuffered);
  playhead_ = new QCPItemStraightLine(plot_);
  playhead_->setLayer(QStringLiteral("playhead"));
  setFrame(0);

  connect(plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) seekTo(event->pos().x());
  });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) seekTo(event->pos().x());
  });
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, &ErrorGraph::showAll);
  plot_->installEventFilter(this);
  applyColours();
  redraw();
  showAll();
}

void ErrorGraph::setErrors(ErrorsPtr errors, double sample_rate_hz,
                           std::vector<ErrorCurve> curves) {
  const bool same_time = errors_ && errors &&
                         errors_->distances.rows() == errors->distances.rows() &&
                         sample_rate_hz == sample_rate_hz_;
  errors_ = std::move(errors);
  sample_rate_hz_ = sample_rate_hz;
  curves_ = std::move(curves);
  redraw();
  if (!same_time) showAll();
}

void ErrorGraph::setCurves(std::vector<ErrorCurve> curves) {
  curves_ = std::move(curves);
  redraw();
}

void ErrorGraph::setQuantity(ErrorQuantity quantity) {
  if (quantity == quantity_) return;
  quantity_ = quantity;
  redraw();
}

void ErrorGraph::setSwitch(QAction* action) {
  delete switch_;
  switch_ = new SwitchButton(action, this);
  beside_legend_->setMinimumSize(switch_->sizeHint());
  placeSwitch();
  fitLegend();
}

/// Lays the legend out in the fewest lines in which every name fits beside the switch. In a low
/// panel, the legend has one line: it omits the worst of all joints first, then curves from the
/// end. The time axis has no title then. The tool tip names all curves.
void ErrorGraph::fitLegend() {
  QCPLegend& legend = *plot_->legend;
  const bool is_low = height() < kRoomy;
  plot_->xAxis->setLabel(is_low ? QString() : tr("Time (s)"));
  plot_->yAxis->ticker()->setTickCount(is_low ? 2 : 5);
  std::vector<QCPGraph*> named;
  for (int i = 0; i < plot_->graphCount(); ++i) {
    plot_->graph(i)->removeFromLegend();
    named.push_back(plot_->graph(i));
  }
  for (QCPGraph* graph : named) graph->addToLegend();
  int columns = legendColumns();
  while (is_low && columns < static_cast<int>(named.size()) && named.size() > 1) {
    const auto least = named.size() == static_cast<std::size_t>(plot_->graphCount())
                           ? named.begin()
                           : named.end() - 1;
    (*least)->removeFromLegend();
    named.erase(least);
    columns = legendColumns();
  }
  legend.setWrap(columns);
  legend.setFillOrder(QCPLayoutGrid::foColumnsFirst);  // arranges the items again
}

/// The largest number of legend columns at which every name fits beside the switch.
int ErrorGraph::legendColumns() const {
  const QCPLegend& legend = *plot_->legend;
  const QMargins margins = legend.margins();
  const int room = width() - margins.left() - margins.right() -
                   (switch_ ? switch_->sizeHint().width() + 2 * kSwitchMargin : 0);
  std::vector<int> widths;
  for (int i = 0; i < legend.itemCount(); ++i)
    if (const auto* item = legend.item(i))  // the last line may have empty cells
      widths.push_back(item->minimumOuterSizeHint().width());
  const auto width_in = [&](int columns) {
    int sum = (columns - 1) * legend.columnSpacing();
    for (int column = 0; column < columns; ++column) {
      int widest = 0;
      for (auto i = static_cast<std::size_t>(column); i < widths.size();
           i += static_cast<std::size_t>(columns))
        widest = std::max(widest, widths[i]);
      sum += widest;
    }
    return sum;
  };
  int columns = std::max(static_cast<int>(widths.size()), 1);
  while (columns > 1 && width_in(columns) > room) --columns;
  return columns;
}

/// Puts the switch into the legend's row, at the right end.
void ErrorGraph::placeSwitch() {
  if (!switch_) return;
  const QSize size = switch_->sizeHint();
  switch_->setGeometry({{width() - size.width() - kSwitchMargin, kSwitchMargin}, size});
}

void ErrorGraph::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeSwitch();
  fitLegend();
  plot_->replot(QCustomPlot::rpQueuedReplot);  // the resize drew the plot with the old legend
}

const Eigen::MatrixXf& ErrorGraph::shown() const {
  static const Eigen::MatrixXf kUnknown;
  return errors_ ? errorsOver(*errors_, quantity_) : kUnknown;
}

void ErrorGraph::setFrame(int frame) {
  const double seconds = frame / sample_rate_hz_;
  playhead_->point1->setCoords(seconds, 0);
  playhead_->point2->setCoords(seconds, 1);
  if (std::exchange(playhead_waits_, true)) return;
  // Waits for pending changes of the curves, so that they are not drawn twice.
  QTimer::singleShot(0, this, [this] {
    playhead_waits_ = false;
    plot_->layer(QStringLiteral("playhead"))->replot();
  });
}

void ErrorGraph::redraw() {
  plot_->clearGraphs();
  plot_->legend->setVisible(errors_ != nullptr);
  plot_->yAxis->setLabel(quantity_ == ErrorQuantity::Angle ? tr("Angle (°)") : tr("Error (cm)"));
  if (shown().size() > 0) {
    addWorst();
    for (const ErrorCurve& curve : curves_) addCurve(curve);
  }
  fitLegend();
  scaleErrors();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// Scales the error axis to the largest error of the clip, or of the range.
void ErrorGraph::scaleErrors() {
  const Eigen::MatrixXf& errors = shown();
  double highest = 0;
  if (errors.size() > 0) {
    const auto last = static_cast<int>(errors.rows()) - 1;
    const auto [from, to] = range_.value_or(std::pair(0, last));
    const int first = std::clamp(from, 0, last);
    highest = static_cast<double>(
        errors.middleRows(first, std::clamp(to, first, last) - first + 1).maxCoeff());
  }
  plot_->yAxis->setRange(0, highest > 0 ? 1.08 * highest : 1);
}

void ErrorGraph::setRange(const std::optional<std::pair<int, int>>& range) {
  range_ = range;
  if (!range) {
    scaleErrors();
    return showAll();
  }
  plot_->xAxis->setRange(range->first / sample_rate_hz_, range->second / sample_rate_hz_);
  scaleErrors();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorGraph::addWorst() {
  QColor grey = palette().color(QPalette::Text);
  grey.setAlphaF(0.18F);
  QCPGraph* graph = plot_->addGraph();
  graph->setName(tr("worst of all joints"));
  graph->setPen(QPen(grey, 1));
  graph->setBrush(grey);
  graph->data()->set(overTime(shown().rowwise().maxCoeff().cast<double>(), sample_rate_hz_), true);
}

void ErrorGraph::addCurve(const ErrorCurve& curve) {
  QCPGraph* graph = plot_->addGraph();
  graph->setName(curve.name);
  graph->setPen(QPen(curve.colour, 1));
  graph->data()->set(overTime(shown().col(curve.landmark).cast<double>(), sample_rate_hz_), true);
}

void ErrorGraph::showAll() {
  const double seconds = errors_ ? static_cast<double>(shown().rows() - 1) / sample_rate_hz_ : 1;
  plot_->xAxis->setRange(0, std::max(seconds, 1 / sample_rate_hz_));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorGraph::seekTo(int x_pixel) {
  if (shown().size() > 0) emit seekRequested(frameAt(x_pixel));
}

int ErrorGraph::frameAt(int x_pixel) const {
  const double frame = std::round(plot_->xAxis->pixelToCoord(x_pixel) * sample_rate_hz_);
  return static_cast<int>(std::clamp(frame, 0.0, static_cast<double>(shown().rows() - 1)));
}

/// The tool tip: both errors of every curve and of the worst landmark.
QString ErrorGraph::readout(int frame) const {
  QStringList lines = {tr("Frame %L1").arg(frame + 1)};
  const auto add = [&lines](const QString& name, const QString& errors) {
    lines << tr("%1: %2").arg(name, errors);
  };
  for (const ErrorCurve& curve : curves_)
    add(curve.name, errorsText(*errors_, frame, curve.landmark));
  const auto worst = [&](ErrorQuantity quantity) {
    const auto error = static_cast<double>(errorsOver(*errors_, quantity).row(frame).maxCoeff());
    return errorText(error, quantity);
  };
  add(tr("worst of all joints"),
      worst(ErrorQuantity::Distance) + QStringLiteral(" · ") + worst(ErrorQuantity::Angle));
  return lines.join(QLatin1Char('\n'));
}

bool ErrorGraph::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ToolTip || shown().size() == 0)
    return QWidget::eventFilter(watched, event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (!plot_->axisRect()->rect().contains(help->pos())) return false;  // the plot's own tool tip
  QToolTip::showText(help->globalPos(), readout(frameAt(help->pos().x())), plot_);
  return true;
}

void ErrorGraph::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  applyColours();
  redraw();
}

void ErrorGraph::applyColours() {
  applyPalette(plot_);
  plot_->legend->setBrush(Qt::NoBrush);
  plot_->legend->setTextColor(palette().color(QPalette::Text));
  plot_->legend->setFont(font());
  playhead_->setPen(QPen(palette().color(QPalette::Text), 1.2));
}

}  // namespace mocapress
