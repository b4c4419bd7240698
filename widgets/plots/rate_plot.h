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

/// Compression ratio against eps_x (cm), both logarithmic, a curve a series. Points tell what they
/// are and can be chosen; the wheel zooms, dragging moves, a double click shows all.
class RatePlot : public QWidget {
  Q_OBJECT

 public:
  /// What a point is, by its row.
  using Describe = std::function<QString(int row)>;

  explicit RatePlot(QWidget* parent = nullptr);

  void setDescribe(Describe describe) { describe_ = std::move(describe); }
  void setCurves(std::vector<RateCurve> curves);

  /// Of eps_x.
  void setWeighting(Weighting weighting);

  /// Where the setting is that the studio shows now; unset: nowhere here.
  void setHere(const std::optional<CurvePoint>& here);

  /// Rings the point of a row; -1: none.
  void setCurrentRow(int row);

  /// What to read while there are no curves.
  void setHint(const QString& hint);

  /// Of exported pictures.
  void setTitle(const QString& title) { title_ = title; }

  const std::vector<RateCurve>& curves() const { return curves_; }

  /// Where a point is drawn, in this widget's pixels.
  QPoint positionOf(const RatePoint& point) const;

  /// The plot as a picture for paper, whatever the palette and size of the widget. Empty when it
  /// could not be made.
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
  QCPItemText* here_label_;  // on the side where there is room
  Describe describe_;
  std::vector<RateCurve> curves_;
  std::optional<CurvePoint> here_;
  Weighting weighting_ = Weighting::BoneEnds;
  QString title_;
  int current_row_ = -1;
  bool moved_ = false;  // by the user: new points leave the axes alone
  QPoint pressed_at_;
};

}  // namespace mocapress
