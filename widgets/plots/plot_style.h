// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVector>

#include <Eigen/Core>

class QCPAxis;
class QCPGraphData;
class QCustomPlot;
class QFont;
class QPalette;

namespace mocapress {

/// Axes, grid and background in the palette of the widget the plot is in: call again when that
/// changes. Has it drawn with the window's next picture rather than at once, maybe several times.
void applyPalette(QCustomPlot* plot);

/// The same for one axis of a plot that has more.
void applyPalette(QCPAxis* axis, const QPalette& palette, const QFont& font);

/// One point a frame, against seconds.
QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz);

}  // namespace mocapress
