// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_style.h"

#include <qcustomplot.h>

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace mocapress {

void applyPalette(QCPAxis* axis, const QPalette& palette, const QFont& font) {
  const QColor text = palette.color(QPalette::Text);
  QColor faint = text;
  faint.setAlphaF(0.12F);
  QColor line = text;
  line.setAlphaF(0.45F);
  axis->setBasePen(QPen(line, 1));
  axis->setTickPen(QPen(line, 1));
  axis->setSubTickPen(Qt::NoPen);
  axis->setTickLabelColor(text);
  axis->setLabelColor(text);
  axis->setTickLabelFont(font);
  axis->setLabelFont(font);
  axis->grid()->setPen(QPen(faint, 1));
  axis->grid()->setZeroLinePen(QPen(faint, 1));
}

void applyPalette(QCustomPlot* plot) {
  // The plot's own palette is updated only after that of its parent widget.
  const QPalette palette = plot->parentWidget()->palette();
  plot->setPlottingHint(QCP::phImmediateRefresh, false);
  plot->setBackground(palette.brush(QPalette::Base));
  for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) applyPalette(axis, palette, plot->font());
}

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Plots)
};

}  // namespace

void offerCopyImage(QWidget* plot) {
  auto* copy = new QAction(Texts::tr("Copy Image"), plot);
  QObject::connect(copy, &QAction::triggered, plot,
                   [plot] { QGuiApplication::clipboard()->setPixmap(plot->grab()); });
  const auto offer = [copy](QWidget* part) {
    part->addAction(copy);
    part->setContextMenuPolicy(Qt::ActionsContextMenu);
  };
  offer(plot);
  for (QCustomPlot* const part : plot->findChildren<QCustomPlot*>()) {
    offer(part);                            // a QCustomPlot does not pass clicks to its parent
    part->setFocusPolicy(Qt::StrongFocus);  // also by Tab, so that the menu key works
  }
}

QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz) {
  QVector<QCPGraphData> points;
  points.reserve(static_cast<int>(values.size()));
  for (Eigen::Index frame = 0; frame < values.size(); ++frame)
    points.append({static_cast<double>(frame) / sample_rate_hz, values[frame]});
  return points;
}

QVector<double> LogTicker::createTickVector(double, const QCPRange& range) {
  constexpr double kLeastGap = 0.12;  // share of the axis: room for a label
  QVector<double> ticks;
  if (!(range.lower > 0)) return ticks;
  const double decades = std::log10(range.upper / range.lower);
  const auto is_crowded = [&](double a, double b) {
    return std::log10(b / a) < kLeastGap * decades;
  };
  for (const auto& digits :
       std::initializer_list<std::vector<int>>{{1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 5}, {1}}) {
    ticks.clear();
    for (double decade = std::pow(10, std::floor(std::log10(range.lower))); decade <= range.upper;
         decade *= 10)
      for (const int digit : digits)
        if (range.contains(digit * decade)) ticks << digit * decade;
    if (ticks.size() > 1 &&
        std::adjacent_find(ticks.begin(), ticks.end(), is_crowded) == ticks.end())
      return ticks;
  }
  return decades > 1 ? ticks
                     : QCPAxisTicker::createTickVector(QCPAxisTicker::getTickStep(range), range);
}

QString LogTicker::getTickLabel(double tick, const QLocale& locale, QChar, int) {
  return locale.toString(tick, 'g', 6) + unit_;
}

}  // namespace mocapress
