// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>
#include <Eigen/Core>
#include <QAction>
#include <QToolButton>
#include <QVector>

namespace mocapress {

/// Gives axes, grid and background the palette of the plot's parent widget; call it again when that
/// changes. The plot is redrawn with the window's next picture, however often this is called.
void applyPalette(QCustomPlot* plot);

/// The same for one axis of a plot with more of them.
void applyPalette(QCPAxis* axis, const QPalette& palette, const QFont& font);

inline QColor fainter(QColor colour, float alpha) {
  colour.setAlphaF(alpha);
  return colour;
}

/// Adds "Copy Image" to the context menu of a plot.
void offerCopyImage(QWidget* plot);

/// Makes a point for each frame, against seconds.
QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz);

/// Ticks of a logarithmic axis: every digit, 1, 2 and 5, or whole decades, whichever is the finest
/// with room for its labels. A range within one digit gets equal steps.
class LogTicker : public QCPAxisTicker {
 public:
  /// `unit` follows each number, such as ":1".
  explicit LogTicker(const QString& unit = {}) : unit_(unit) {}

 protected:
  QVector<double> createTickVector(double, const QCPRange& range) override;
  double getTickStep(const QCPRange&) override { return 1; }
  int getSubTickCount(double) override { return 0; }
  QString getTickLabel(double tick, const QLocale& locale, QChar, int) override;

 private:
  QString unit_;
};

/// A button that shows an action as a word in the corner of a plot. Its frame keeps it from reading
/// as a unit. A click leaves the keyboard focus with the plot.
class SwitchButton : public QToolButton {
 public:
  SwitchButton(QAction* action, QWidget* plot) : QToolButton(plot) {
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
  }
};

}  // namespace mocapress
