// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QWidget>
#include <memory>
#include <vector>

class QCPItemStraightLine;
class QCustomPlot;

namespace mocapress {

/// One landmark's error over time.
struct ErrorCurve {
  QString name;
  QColor colour;
  int landmark = 0;
};

/// Distance from the original (cm) over time (s): a curve for each chosen landmark over the shape
/// of the worst of all, and a playhead. A click or drag seeks, the wheel zooms time, a double click
/// shows all of it.
class ErrorGraph : public QWidget {
  Q_OBJECT

 public:
  using Distances = std::shared_ptr<const Eigen::MatrixXf>;  // frames x landmarks, cm

  explicit ErrorGraph(QWidget* parent = nullptr);

  /// Null: nothing to show. `curves` are of the landmarks of `distances`.
  void setDistances(Distances distances, double sample_rate_hz, std::vector<ErrorCurve> curves);
  void setCurves(std::vector<ErrorCurve> curves);
  void setFrame(int frame);

 signals:
  void seekRequested(int frame);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void redraw();
  void addCurve(const ErrorCurve& curve);
  void addWorst();
  void showAll();
  void seekTo(int x_pixel);
  void applyColours();

  QCustomPlot* plot_;
  QCPItemStraightLine* playhead_;
  bool playhead_waits_ = false;  // to be drawn
  Distances distances_;
  double sample_rate_hz_ = 120;
  std::vector<ErrorCurve> curves_;
};

}  // namespace mocapress
