// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>
#include <Eigen/Core>
#include <QAction>
#include <QToolButton>
#include <QVector>

namespace mocapress {

/// Applies the palette of the plot's parent widget to axes, grid and background; to be called again
/// when the palette changes. However often it is called, the plot is redrawn once, with the
/// window's next repaint.
void applyPalette(QCustomPlot* plot);

/// Applies a palette and a font to one axis, for plots with several axis areas.
void applyPalette(QCPAxis* axis, const QPalette& palette, const QFont& font);

inline QColor fainter(QColor colour, float alpha) {
  colour.setAlphaF(alpha);
  return colour;
}

/// Adds "Copy Image" to the context menu of a plot.
void offerCopyImage(QWidget* plot);

/// Makes one point for each frame, with the time in seconds.
QVector<QCPGraphData> overTime(const Eigen::VectorXd& values, double sample_rate_hz);

/// Places ticks on a logarithmic axis: at every digit, at 1, 2 and 5, or at powers of ten,
/// whichever is the finest with room for its labels. A range shorter than a decade that has room
/// for none of these gets equal steps.
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

/// A button in the corner of a plot that shows an action as a word. Its frame distinguishes the
/// word from the unit of an axis. A click leaves the keyboard focus with the plot.
class SwitchButton : public QToolButton {
 public:
  SwitchButton(QAction* action, QWidget* plot) : QToolButton(plot) {
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::TabFocus);
  }
};

}  // namespace mocapress
