// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "core/codec/encoder.h"

class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace mocapress {

/// What is asked for, a size or a quality, on a slider of equal factors with a spin box beside it.
class TargetControl : public QWidget {
  Q_OBJECT

 public:
  explicit TargetControl(QWidget* parent = nullptr);

  const Target& target() const { return target_; }

  /// Of any kind but CoefficientRatio. Emits nothing.
  void setTarget(const Target& target);

  QSlider* slider() const { return slider_; }

 signals:
  void targetChanged(const Target& target);

 private:
  void choose(const Target& target);
  void show();

  Target target_;
  std::map<Target::Kind, double> values_;  // of kinds not shown, for when they are chosen again
  QComboBox* kind_;
  QSlider* slider_;
  QDoubleSpinBox* value_;
};

}  // namespace mocapress
