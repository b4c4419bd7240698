// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/models/error_colour.h"

class QCPItemStraightLine;
class QCPLayoutElement;
class QCustomPlot;

namespace mocapress {

class SwitchButton;

/// One landmark's error over time.
struct ErrorCurve {
  QString name;
  QColor colour;
  int landmark = 0;
};

/// Plots the errors of one quantity over time (s): a curve for each chosen landmark, the maximum of
/// all landmarks as an area, and a playhead. Hovering shows both quantities at that time. A click
/// or drag seeks, the wheel zooms time, a double click shows the whole clip.
class ErrorGraph : public QWidget {
  Q_OBJECT

 public:
  explicit ErrorGraph(QWidget* parent = nullptr);

  /// Sets the errors (null: nothing is shown), and the curves, which are landmarks of `errors`.
  void setErrors(ErrorsPtr errors, double sample_rate_hz, std::vector<ErrorCurve> curves);

  void setQuantity(ErrorQuantity quantity);

  /// Sets the action in the corner that switches to the other quantity.
  void setSwitch(QAction* action);

  /// Shows only these frames, scaled to their own largest error; unset: all frames.
  void setRange(const std::optional<std::pair<int, int>>& range);

  void setCurves(std::vector<ErrorCurve> curves);
  void setFrame(int frame);

 signals:
  void seekRequested(int frame);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void redraw();
  void addCurve(const ErrorCurve& curve);
  void addWorst();
  void showAll();
  void scaleErrors();
  void seekTo(int x_pixel);
  int frameAt(int x_pixel) const;
  QString readout(int frame) const;
  void placeSwitch();
  void fitLegend();
  int legendColumns() const;

  /// The shown errors, frames x landmarks; empty: unknown.
  const Eigen::MatrixXf& shown() const;
  void applyColours();

  QCustomPlot* plot_;
  QCPItemStraightLine* playhead_;
  bool playhead_waits_ = false;      // a redraw is pending
  QCPLayoutElement* beside_legend_;  // cell that holds the switch
  SwitchButton* switch_ = nullptr;
  ErrorsPtr errors_;
  ErrorQuantity quantity_ = ErrorQuantity::Distance;
  double sample_rate_hz_ = 120;
  std::optional<std::pair<int, int>> range_;
  std::vector<ErrorCurve> curves_;
};

}  // namespace mocapress
