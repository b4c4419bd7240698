// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/rate_plot.h"

#include <qcustomplot.h>

#include <QFile>
#include <QTemporaryDir>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {
namespace {

constexpr int kLeastHeight = 110;        // px; leaves room for the axes in the lowest panel
constexpr double kReach = 12;            // px between the mouse and a point whose text it shows
constexpr int kBeside = 9;               // px from the mark to its label
constexpr int kBelow = 6;                // px
constexpr int kStill = 4;                // px the mouse may move during a click
constexpr QSize kPictureSize(960, 640);  // px at scale 1; points on a page
constexpr double kPictureScale = 2;

QCPScatterStyle markOf(const SeriesStyle& style, const QColor& background, double size) {
  using Shape = QCPScatterStyle::ScatterShape;
  constexpr std::array<Shape, kSeriesShapes> kShapes = {
      QCPScatterStyle::ssCircle, QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
      QCPScatterStyle::ssDiamond, QCPScatterStyle::ssTriangleInverted};
  const QColor fill = style.hollow ? background : style.colour;
  return {kShapes[static_cast<std::size_t>(style.shape)], QPen(style.colour, 1.4), QBrush(fill),
          size};
}

QPalette paper() {
  QPalette palette(Qt::white);
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::Text, Qt::black);
  return palette;
}

}  // namespace

RatePlot::RatePlot(QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot(this)),
      hint_(new QCPItemText(plot_)),
      here_label_(new QCPItemText(plot_)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  plot_->setMinimumHeight(kLeastHeight);
  plot_->axisRect()->setMinimumSize(50, 15);  // in a low panel the curves shrink, not the axis
  offerCopyImage(this);
  plot_->setAccessibleName(tr("Rate-distortion plot"));
  plot_->setAccessibleDescription(
      tr("Error over compression ratio, one curve for each method. The table below lists every "
         "point."));
  plot_->xAxis->setLabel(tr("Compression ratio (smaller files →)"));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->setScaleType(QCPAxis::stLogarithmic);
  plot_->xAxis->setTicker(QSharedPointer<LogTicker>::create(QStringLiteral(":1")));
  plot_->yAxis->setTicker(QSharedPointer<LogTicker>::create());
  plot_->setInteractions(QCP::iRangeZoom | QCP::iRangeDrag);
  plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
  plot_->legend->setIconSize(26, fontMetrics().height());
  plot_->legend->setRowSpacing(2);

  hint_->position->setType(QCPItemPosition::ptAxisRectRatio);
  hint_->position->setCoords(0.5, 0.5);
  here_label_->setText(tr("current result"));
  connect(plot_, &QCustomPlot::afterLayout, this, &RatePlot::placeHereLabel);
  connectMouse();
  applyColours();
  setWeighting(weighting_);
  redraw();
}

void RatePlot::connectMouse() {
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
    if ((event->pos() - pressed_at_).manhattanLength() > kStill) return;
    if (const RatePoint* point = pointAt(event->pos())) emit pointChosen(point->row);
  });
  connect(plot_, &QCustomPlot::mouseWheel, this, [this] { moved_ = true; });
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this](const QMouseEvent* event) {
    if (pointAt(event->pos())) return;
    moved_ = false;
    showAll();
    plot_->replot(QCustomPlot::rpQueuedReplot);
  });
}

void RatePlot::setCurves(std::vector<RateCurve> curves) {
  curves_ = std::move(curves);
  redraw();
}

void RatePlot::setWeighting(Weighting weighting) {
  weighting_ = weighting;
  plot_->yAxis->setLabel(tr("eps_x (cm), %1").arg(displayName(weighting).toLower()));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RatePlot::setHere(const std::optional<CurvePoint>& here) {
  here_ = here;
  redraw();
}

void RatePlot::setCurrentRow(int row) {
  current_row_ = row;
  placeMarks();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RatePlot::setHint(const QString& hint) {
  hint_->setText(hint);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RatePlot::redraw() {
  plot_->clearGraphs();
  bool any = false;
  for (const RateCurve& curve : curves_) {
    addCurve(curve);
    any = any || !curve.points.empty();
  }
  plot_->legend->setVisible(any);
  hint_->setVisible(!any);
  const QColor text = palette().color(QPalette::Text);
  ring_ = plot_->addGraph();
  ring_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(text, 1.6), Qt::NoBrush, 15});
  here_mark_ = plot_->addGraph();
  here_mark_->setScatterStyle({QCPScatterStyle::ssCrossCircle, QPen(text, 1.4), Qt::NoBrush, 13});
  for (QCPGraph* mark : {ring_, here_mark_}) {
    mark->setLineStyle(QCPGraph::lsNone);
    mark->removeFromLegend();
  }
  placeMarks();
  if (!moved_) showAll();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RatePlot::addCurve(const RateCurve& curve) {
  if (curve.points.empty()) return;
  const SeriesStyle style = seriesStyle(curve.series.method, curve.series.ik_ratio.has_value());
  const QColor background = palette().color(QPalette::Base);

  SeriesStyle faint = style;
  faint.colour = fainter(style.colour, curve.mean ? 0.4F : 0.55F);
  QCPGraph* points = plot_->addGraph();
  points->setLineStyle(QCPGraph::lsNone);
  points->setScatterStyle(markOf(faint, background, curve.mean ? 4 : 6));
  points->removeFromLegend();
  for (const RatePoint& point : curve.points) points->addData(point.ratio, point.eps_cm);

  QCPGraph* line = plot_->addGraph();
  line->setName(seriesTitle(curve.series.method, curve.series.ik_ratio));
  line->setPen(QPen(style.colour, 2, style.dashed ? Qt::DashLine : Qt::SolidLine));
  line->setScatterStyle(markOf(style, background, 7));
  if (curve.mean) line->setScatterSkip(7);  // draws every 7th mark: the mean has many points
  for (const CurvePoint& point : curve.line) line->addData(point.ratio, point.eps_cm);
}

void RatePlot::placeMarks() {
  ring_->data()->clear();
  if (const RatePoint* point = pointOf(current_row_)) ring_->addData(point->ratio, point->eps_cm);
  here_mark_->data()->clear();
  here_label_->setVisible(here_.has_value());
  if (!here_) return;
  here_mark_->addData(here_->ratio, here_->eps_cm);
  here_label_->position->setCoords(here_->ratio, here_->eps_cm);
}

/// Puts the label at the corner of the mark that is farthest from the curves and, if possible,
/// inside the axes.
void RatePlot::placeHereLabel() {
  if (!here_) return;
  const QPointF mark(plot_->xAxis->coordToPixel(here_->ratio),
                     plot_->yAxis->coordToPixel(here_->eps_cm));
  const QSizeF size = QFontMetricsF(font()).boundingRect(here_label_->text()).size();
  double most = -2;
  for (const bool right : {true, false})
    for (const bool below : {true, false}) {
      const QRectF text({mark.x() + (right ? kBeside : -kBeside - size.width()),
                         mark.y() + (below ? kBelow : -kBelow - size.height())},
                        size);
      const bool fits = QRectF(plot_->axisRect()->rect()).contains(text);
      const double clear = fits ? clearance(text) : -1;
      if (clear <= most) continue;
      most = clear;
      here_label_->setPositionAlignment((right ? Qt::AlignLeft : Qt::AlignRight) |
                                        (below ? Qt::AlignTop : Qt::AlignBottom));
      here_label_->setPadding(
          {right ? kBeside : 0, below ? kBelow : 0, right ? 0 : kBeside, below ? 0 : kBelow});
    }
}

/// Distance in px to the nearest curve; 0 if a curve or the legend is inside.
double RatePlot::clearance(const QRectF& place) const {
  constexpr int kSteps = 16;  // samples between two points of a curve
  if (plot_->legend->visible() && place.intersects(plot_->legend->outerRect())) return 0;
  double least = std::numeric_limits<double>::infinity();
  const auto at = [this](const CurvePoint& point) {
    return QPointF(plot_->xAxis->coordToPixel(point.ratio),
                   plot_->yAxis->coordToPixel(point.eps_cm));
  };
  for (const RateCurve& curve : curves_)
    for (std::size_t i = 1; i < curve.line.size(); ++i) {
      const QPointF from = at(curve.line[i - 1]);
      const QPointF to = at(curve.line[i]);
      for (int step = 0; step <= kSteps; ++step) {
        const QPointF point = from + (to - from) * step / kSteps;
        const double x = std::max({place.left() - point.x(), 0.0, point.x() - place.right()});
        const double y = std::max({place.top() - point.y(), 0.0, point.y() - place.bottom()});
        least = std::min(least, std::hypot(x, y));
      }
    }
  return least;
}

void RatePlot::showAll() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CurvePoint low{kInfinity, kInfinity};
  CurvePoint high{0, 0};
  const auto include = [&](double ratio, double eps_cm) {
    low = {std::min(low.ratio, ratio), std::min(low.eps_cm, eps_cm)};
    high = {std::max(high.ratio, ratio), std::max(high.eps_cm, eps_cm)};
  };
  for (const RateCurve& curve : curves_)
    for (const RatePoint& point : curve.points) include(point.ratio, point.eps_cm);
  if (!(high.ratio > 0)) include(5, 0.05), include(60, 3);
  if (here_) include(here_->ratio, here_->eps_cm);
  plot_->xAxis->setRange(low.ratio / 1.12, high.ratio * 1.12);
  plot_->yAxis->setRange(low.eps_cm / 1.25, high.eps_cm * 1.25);
}

QPoint RatePlot::positionOf(const RatePoint& point) const {
  const QPointF position(plot_->xAxis->coordToPixel(point.ratio),
                         plot_->yAxis->coordToPixel(point.eps_cm));
  return plot_->mapTo(this, position.toPoint());
}

const RatePoint* RatePlot::pointAt(const QPoint& position) const {
  const RatePoint* nearest = nullptr;
  double least = kReach;
  for (const RateCurve& curve : curves_)
    for (const RatePoint& point : curve.points) {
      const QPointF away(plot_->xAxis->coordToPixel(point.ratio) - position.x(),
                         plot_->yAxis->coordToPixel(point.eps_cm) - position.y());
      const double distance = std::hypot(away.x(), away.y());
      if (distance > least) continue;
      least = distance;
      nearest = &point;
    }
  return nearest;
}

const RatePoint* RatePlot::pointOf(int row) const {
  for (const RateCurve& curve : curves_)
    for (const RatePoint& point : curve.points)
      if (point.row == row) return &point;
  return nullptr;
}

void RatePlot::hover(const QPoint& position) {
  const RatePoint* point = pointAt(position);
  plot_->setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (point && describe_)
    QToolTip::showText(plot_->mapToGlobal(position + QPoint(12, 12)), describe_(point->row), plot_);
  else
    QToolTip::hideText();
}

/// Draws a separate plot for export, so that the plot on the screen stays as it is.
template <typename Write>
QByteArray RatePlot::picture(Write write) const {
  RatePlot copy;
  copy.setPalette(paper());
  copy.applyColours();
  copy.setWeighting(weighting_);
  copy.setCurves(curves_);
  QCustomPlot* plot = copy.plot_;
  plot->plotLayout()->insertRow(0);
  QFont font = this->font();
  font.setWeight(QFont::DemiBold);
  auto* title = new QCPTextElement(plot, title_, font);
  title->setMargins(QMargins(0, 10, 0, 4));
  plot->plotLayout()->addElement(0, 0, title);
  // QCustomPlot can only write to files.
  const QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("plot")));
  if (!write(plot, file.fileName()) || !file.open(QIODevice::ReadOnly)) return {};
  return file.readAll();
}

QByteArray RatePlot::png() const {
  return picture([](QCustomPlot* plot, const QString& path) {
    return plot->savePng(path, kPictureSize.width(), kPictureSize.height(), kPictureScale);
  });
}

QByteArray RatePlot::pdf() const {
  return picture([this](QCustomPlot* plot, const QString& path) {
    return plot->savePdf(path, kPictureSize.width(), kPictureSize.height(), QCP::epNoCosmetic,
                         QCoreApplication::applicationName(), title_);
  });
}

void RatePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  applyColours();
  redraw();
}

void RatePlot::applyColours() {
  applyPalette(plot_);
  const QColor text = palette().color(QPalette::Text);
  plot_->legend->setBrush(fainter(palette().color(QPalette::Base), 0.85F));
  plot_->legend->setBorderPen(Qt::NoPen);
  plot_->legend->setTextColor(text);
  plot_->legend->setFont(font());
  hint_->setColor(fainter(text, 0.6F));
  hint_->setFont(font());
  here_label_->setColor(text);
  here_label_->setFont(font());
}

}  // namespace mocapress
