// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "core/codec/format/compressed_clip.h"
#include "widgets/models/rate_curves.h"

class QCPGraph;
class QCPItemText;
class QCPTextElement;
class QCustomPlot;

namespace mocapress {

/// Plots eps_x (cm) over the compression ratio, both logarithmic, with a curve for each series.
/// Points have tool tips and can be chosen; the wheel zooms, dragging moves, a double click shows
/// all.
class RatePlot : public QWidget {
  Q_OBJECT

 public:
  /// Describes a row of the study, for the tool tip of its point.
  using Describe = std::function<QString(int row)>;

  explicit RatePlot(QWidget* parent = nullptr);

  void setDescribe(Describe describe) { describe_ = std::move(describe); }
  void setCurves(std::vector<RateCurve> curves);

  /// Sets the weighting that the axis names for eps_x.
  void setWeighting(Weighting weighting);

  /// Sets the point of the studio's current settings; unset: none.
  void setHere(const std::optional<CurvePoint>& here);

  /// Draws a ring around the point of a row; -1: none.
  void setCurrentRow(int row);

  /// Sets a text that is shown while there are no curves.
  void setHint(const QString& hint);

  /// Sets the title of exported pictures.
  void setTitle(const QString& title) { title_ = title; }

  const std::vector<RateCurve>& curves() const { return curves_; }

  /// The position of a point in pixels of this widget.
  QPoint positionOf(const RatePoint& point) const;

  /// The plot as a picture for print, independent of the widget's palette and size. Empty on
  /// failure.
  QByteArray png() const;
  QByteArray pdf() const;

 signals:
  void pointChosen(int row);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectMouse();
  void redraw();
  void addCurve(const RateCurve& curve);
  void placeMarks();
  void showAll();
  void placeHereLabel();
  double clearance(const QRectF& place) const;
  void applyColours();
  const RatePoint* pointAt(const QPoint& position) const;
  const RatePoint* pointOf(int row) const;
  void hover(const QPoint& position);
  template <typename Write>
  QByteArray picture(Write write) const;

  QCustomPlot* plot_;
  QCPGraph* here_mark_ = nullptr;
  QCPGraph* ring_ = nullptr;
  QCPItemText* hint_;
  QCPItemText* here_label_;  // at the corner with the most room
  Describe describe_;
  std::vector<RateCurve> curves_;
  std::optional<CurvePoint> here_;
  Weighting weighting_ = Weighting::BoneEnds;
  QString title_;
  int current_row_ = -1;
  bool moved_ = false;  // the user moved the axes: new points do not move them
  QPoint pressed_at_;
};

}  // namespace mocapress
