// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_style.h"

#include <qcustomplot.h>
#include <cmath>

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
  // Of the widget around it, which hears of a change first.
  const QPalette palette = plot->parentWidget()->palette();
  plot->setPlottingHint(QCP::phImmediateRefresh, false);
  plot->setBackground(palette.brush(QPalette::Base));
  for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) applyPalette(axis, palette, plot->font());
}

QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz) {
  QVector<QCPGraphData> points;
  points.reserve(static_cast<int>(values.size()));
  for (Eigen::Index frame = 0; frame < values.size(); ++frame)
    points.append({static_cast<double>(frame) / sample_rate_hz, values[frame]});
  return points;
}

namespace {

/// Whether a digit is labelled in a range of so many decades.
bool labelled(int digit, double decades) {
  if (digit == 1 || decades < 0.9) return true;
  return decades < 4.6 && (digit == 2 || digit == 5);
}

}  // namespace

QVector<double> LogTicker::createTickVector(double, const QCPRange& range) {
  QVector<double> ticks;
  if (!(range.lower > 0)) return ticks;
  const double decades = std::log10(range.upper / range.lower);
  for (double decade = std::pow(10, std::floor(std::log10(range.lower))); decade <= range.upper;
       decade *= 10)
    for (int digit = 1; digit < 10; ++digit)
      if (labelled(digit, decades) && digit * decade >= range.lower &&
          digit * decade <= range.upper)
        ticks << digit * decade;
  return ticks;
}

QString LogTicker::getTickLabel(double tick, const QLocale& locale, QChar, int) {
  return locale.toString(tick, 'g', 3) + unit_;
}

}  // namespace mocapress
