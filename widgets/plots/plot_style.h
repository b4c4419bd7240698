// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>
#include <Eigen/Core>
#include <QAction>
#include <QToolButton>
#include <QVector>

namespace mocapress {

/// Axes, grid and background in the palette of the widget the plot is in: call again when that
/// changes. Has it drawn with the window's next picture rather than at once, maybe several times.
void applyPalette(QCustomPlot* plot);

/// The same for one axis of a plot that has more.
void applyPalette(QCPAxis* axis, const QPalette& palette, const QFont& font);

/// One point a frame, against seconds.
QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz);

/// Ticks of a logarithmic axis that is read at a glance: as many as have room for their labels, of
/// every digit, of 1, 2, 5, or of whole decades. In a range of less than a digit: equal steps.
class LogTicker : public QCPAxisTicker {
 public:
  /// `unit` follows each number: ":1".
  explicit LogTicker(const QString& unit = {}) : unit_(unit) {}

 protected:
  QVector<double> createTickVector(double, const QCPRange& range) override;
  double getTickStep(const QCPRange&) override { return 1; }
  int getSubTickCount(double) override { return 0; }
  QString getTickLabel(double tick, const QLocale& locale, QChar, int) override;

 private:
  QString unit_;
};

/// An action as a word in the corner of a plot. With a frame: without, it reads as the unit of what
/// is shown. A click leaves the keys with the plot.
class SwitchButton : public QToolButton {
 public:
  SwitchButton(QAction* action, QWidget* plot) : QToolButton(plot) {
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
  }
};

}  // namespace mocapress
