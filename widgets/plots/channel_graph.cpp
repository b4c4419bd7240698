// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/channel_graph.h"

#include <qcustomplot.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/models/colours.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

constexpr int kBandsWidth = 240;  // pixels: room for a number below each bar

void paintAxes(QCPAxisRect* area, const QPalette& palette, const QFont& font) {
  for (QCPAxis* axis : {area->axis(QCPAxis::atBottom), area->axis(QCPAxis::atLeft)})
    applyPalette(axis, palette, font);
}

void fit(QCPAxis* axis, double low, double high) {
  const double least = 1e-6;
  const double room = std::max(0.06 * (high - low), least);
  axis->setRange(low - room, high + room);
}

}  // namespace

ChannelGraph::ChannelGraph(QWidget* parent)
    : QWidget(parent),
      channels_(new QComboBox(this)),
      hint_(new QLabel(this)),
      curves_plot_(new QCustomPlot(this)),
      bands_plot_(new QCustomPlot(this)) {
  channels_->setAccessibleName(tr("Channel"));
  channels_->setToolTip(tr("One degree of freedom of the selected joint."));
  channels_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  offerCopyImage(this);
  curves_plot_->setAccessibleName(tr("Channel over time"));
  curves_plot_->setToolTip(tr(
      "The recorded and the compressed channel; below, their difference. Click to go to a frame."));
  bands_plot_->setAccessibleName(tr("Kept coefficients by scale"));
  bands_plot_->setToolTip(
      tr("Share of this channel's wavelet coefficients that are kept, from the coarsest scale to "
         "the finest."));
  bands_plot_->setFixedWidth(kBandsWidth);

  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 2, 8, 0);
  head->addWidget(channels_);
  head->addWidget(hint_, 1);
  auto* plots = new QHBoxLayout;
  plots->setSpacing(0);
  plots->addWidget(curves_plot_, 1);
  plots->addWidget(bands_plot_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(head);
  column->addLayout(plots, 1);

  curves_plot_->setNotAntialiasedElements(QCP::aePlottables);
  difference_ = new QCPAxisRect(curves_plot_);
  curves_plot_->plotLayout()->addElement(1, 0, difference_);
  curves_plot_->plotLayout()->setRowStretchFactor(0, 1.6);
  curves_plot_->plotLayout()->setRowSpacing(0);
  auto* margins = new QCPMarginGroup(curves_plot_);
  for (QCPAxisRect* area : {curves_plot_->axisRect(), difference_})
    area->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  curves_plot_->axisRect()->axis(QCPAxis::atBottom)->setTickLabels(false);
  // The two plots are low, and in a small window narrow, too: more labels would overlap.
  curves_plot_->axisRect()->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  difference_->axis(QCPAxis::atLeft)->ticker()->setTickCount(2);
  for (QCPAxisRect* area : {curves_plot_->axisRect(), difference_})
    area->axis(QCPAxis::atBottom)->ticker()->setTickCount(2);
  difference_->axis(QCPAxis::atBottom)->setLabel(tr("Time (s)"));
  curves_plot_->addLayer(QStringLiteral("playhead"));
  curves_plot_->layer(QStringLiteral("playhead"))->setMode(QCPLayer::lmBuffered);
  for (QCPAxisRect* area : {curves_plot_->axisRect(), difference_}) {
    auto* line = new QCPItemStraightLine(curves_plot_);
    line->setLayer(QStringLiteral("playhead"));
    line->setClipAxisRect(area);
    for (QCPItemPosition* point : {line->point1, line->point2})
      point->setAxes(area->axis(QCPAxis::atBottom), area->axis(QCPAxis::atLeft));
    playheads_.push_back(line);
  }
  bands_plot_->xAxis->setLabel(tr("Scale (finer →)"));
  bands_plot_->yAxis->setLabel(tr("Kept (%)"));
  bands_plot_->yAxis->setRange(0, 100);

  connect(channels_, &QComboBox::activated, this, &ChannelGraph::channelChosen);
  connect(curves_plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) seekTo(event->pos().x());
  });
  connect(curves_plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) seekTo(event->pos().x());
  });
  applyColours();
  setChannels({}, -1);
  setCurves({});
}

void ChannelGraph::setChannels(const QStringList& names, int current) {
  const QSignalBlocker blocker(channels_);
  channels_->clear();
  channels_->addItems(names);
  channels_->setCurrentIndex(current);
  channels_->setEnabled(!names.isEmpty());
  hint_->setText(names.isEmpty() ? tr("The selected joint has no motion of its own.") : QString());
}

void ChannelGraph::setCurves(const ChannelCurves& curves) {
  curves_ = curves;
  redraw();
}

void ChannelGraph::setFrame(int frame) {
  const double seconds = frame / curves_.sample_rate_hz;
  for (QCPItemStraightLine* line : playheads_) {
    line->point1->setCoords(seconds, 0);
    line->point2->setCoords(seconds, 1);
  }
  if (std::exchange(playhead_waits_, true)) return;
  // Waits for pending changes of the curves, so that they are not drawn twice.
  QTimer::singleShot(0, this, [this] {
    playhead_waits_ = false;
    curves_plot_->layer(QStringLiteral("playhead"))->replot();
  });
}

void ChannelGraph::redraw() {
  drawCurves();
  drawBands();
}

void ChannelGraph::drawCurves() {
  curves_plot_->clearGraphs();
  QCPAxisRect* above = curves_plot_->axisRect();
  const auto add = [&](QCPAxisRect* area, const Eigen::VectorXd& values, const QPen& pen) {
    QCPGraph* graph =
        curves_plot_->addGraph(area->axis(QCPAxis::atBottom), area->axis(QCPAxis::atLeft));
    graph->setPen(pen);
    graph->data()->set(overTime(values, curves_.sample_rate_hz), true);
    fit(area->axis(QCPAxis::atLeft), values.minCoeff(), values.maxCoeff());
  };
  const QString unit = curves_.rotation ? tr("°") : tr("cm");
  above->axis(QCPAxis::atLeft)->setLabel(unit);
  difference_->axis(QCPAxis::atLeft)->setLabel(QStringLiteral("Δ ") + unit);
  const auto& [original, compressed, rotation, kept, rate] = curves_;
  if (original.size() > 0) add(above, original, QPen(palette().color(QPalette::Text), 1));
  if (compressed.size() > 0) add(above, compressed, QPen(QColor(kCurveColours[1]), 1));
  if (original.size() > 0 && original.size() == compressed.size()) {
    const Eigen::VectorXd between = compressed - original;
    add(difference_, between, QPen(QColor(kCurveColours[0]), 1));
    fit(above->axis(QCPAxis::atLeft), std::min(original.minCoeff(), compressed.minCoeff()),
        std::max(original.maxCoeff(), compressed.maxCoeff()));
  }
  const auto frames = std::max(original.size(), compressed.size());
  const double seconds = std::max(1.0, static_cast<double>(frames - 1)) / rate;
  for (QCPAxisRect* area : {above, difference_})
    area->axis(QCPAxis::atBottom)->setRange(0, seconds);
  curves_plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ChannelGraph::drawBands() {
  bands_plot_->clearPlottables();
  auto* bars = new QCPBars(bands_plot_->xAxis, bands_plot_->yAxis);
  bars->setPen(Qt::NoPen);
  bars->setBrush(QColor(kCurveColours[0]));
  bars->setWidth(0.7);
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (std::size_t band = 0; band < curves_.kept.size(); ++band) {
    const KeptBand& kept = curves_.kept[band];
    const auto place = static_cast<double>(band);
    bars->addData(place, 100.0 * kept.kept / std::max(kept.all, 1));
    ticker->addTick(place, QString::number(kept.kept));
  }
  bands_plot_->xAxis->setTicker(ticker);
  bands_plot_->xAxis->setTickLabelRotation(-90);
  bands_plot_->xAxis->setRange(-0.6, std::max<double>(1, double(curves_.kept.size())) - 0.4);
  bands_plot_->setVisible(!curves_.kept.empty());
  bands_plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ChannelGraph::seekTo(int x_pixel) {
  const auto last =
      static_cast<double>(std::max(curves_.original.size(), curves_.compressed.size()) - 1);
  if (last < 0) return;
  const double seconds = difference_->axis(QCPAxis::atBottom)->pixelToCoord(x_pixel);
  const double frame = std::clamp(std::round(seconds * curves_.sample_rate_hz), 0.0, last);
  emit seekRequested(static_cast<int>(frame));
}

void ChannelGraph::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  applyColours();
  redraw();
}

void ChannelGraph::applyColours() {
  applyPalette(curves_plot_);
  applyPalette(bands_plot_);
  paintAxes(difference_, palette(), font());
  for (QCPItemStraightLine* line : playheads_)
    line->setPen(QPen(palette().color(QPalette::Text), 1.2));
}

}  // namespace mocapress
