// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/models/log_scale.h"

class QDoubleSpinBox;
class QSlider;

namespace mocapress {

/// Edits a factor with a logarithmic slider and a spin box beside it.
class FactorControl : public QWidget {
  Q_OBJECT

 public:
  /// `name` is for screen readers. With `from_none` the slider starts at 0, shown as "none".
  FactorControl(const QString& name, const QString& tip, const LogScale& scale, bool from_none,
                QWidget* parent = nullptr);

  double value() const { return value_; }

  /// Emits nothing.
  void setValue(double value);

  QSlider* slider() const { return slider_; }
  QDoubleSpinBox* number() const { return number_; }

 signals:
  void valueChanged(double value);

 private:
  void choose(double value);
  double at(int position) const;

  LogScale scale_;
  bool from_none_;
  double value_;
  QSlider* slider_;
  QDoubleSpinBox* number_;
};

}  // namespace mocapress
