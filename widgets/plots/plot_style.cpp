// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plot_style.h"

#include <qcustomplot.h>

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

}  // namespace mocapress
