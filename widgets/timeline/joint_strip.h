// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/timeline/time_axis.h"

class QPainter;

namespace mocapress {

/// A strip of columns over time, in which each frame stands for one joint. A click or drag shows
/// the frame and its joint.
class JointStrip : public QWidget {
  Q_OBJECT

 public:
  void setFrame(int frame);
  void setWindow(const FrameWindow& window);

  /// Sets the width in pixels for the names at the left, shared with the other strips.
  void setLabelWidth(int pixels);
  int labelWidth() const;

  QSize sizeHint() const override { return {200, height_}; }

 signals:
  void chosen(int frame, int joint);

 protected:
  /// `label` is shown at the left; `height` is in pixels.
  JointStrip(const QString& label, int height, QWidget* parent);

  /// Sets the names of a clip's joints, and its number of frames.
  void setClip(std::vector<QString> names, int frames);
  const QString& nameOf(int joint) const { return names_[static_cast<std::size_t>(joint)]; }

  /// False if there is nothing to draw or to choose.
  virtual bool isKnown() const = 0;
  virtual void paintColumns(QPainter& painter, const QRectF& area, const TimeAxis& time) const = 0;
  virtual int jointAt(int frame) const = 0;

  /// Tool tips: the meaning of the columns, and the values at a frame.
  virtual QString meaning() const = 0;
  virtual QString describe(int frame) const = 0;

 private:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  TimeAxis axis() const;
  void choose(double x);

  QString label_;
  int height_;
  std::vector<QString> names_;
  int frames_ = 0;
  FrameWindow window_;
  int frame_ = 0;
  int label_width_ = 0;
};

}  // namespace mocapress
