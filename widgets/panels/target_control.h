// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/codec/encoder.h"

class QComboBox;
class QDoubleSpinBox;
class QSlider;

namespace mocapress {

/// What is asked for, a ratio or an error, on a slider of equal factors with a spin box beside it.
class TargetControl : public QWidget {
  Q_OBJECT

 public:
  explicit TargetControl(QWidget* parent = nullptr);

  const Target& target() const { return target_; }

  /// Of kind Ratio or Error. Emits nothing.
  void setTarget(const Target& target);

  QSlider* slider() const { return slider_; }

 signals:
  void targetChanged(const Target& target);

 private:
  void choose(const Target& target);
  void show();

  Target target_;
  double other_value_;  // of the kind not shown, for when it is chosen again
  QComboBox* kind_;
  QSlider* slider_;
  QDoubleSpinBox* value_;
};

}  // namespace mocapress
