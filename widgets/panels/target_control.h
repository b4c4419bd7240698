// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>

#include "core/codec/encode/options/target.h"

class QComboBox;
class QLabel;
class QSlider;

namespace mocapress {

class NumberBox;

/// Edits the target, a size or a quality, with a logarithmic slider and a number beside it. The
/// number stays as typed, even outside the slider's range or if the clip cannot reach it.
class TargetControl : public QWidget {
  Q_OBJECT

 public:
  explicit TargetControl(QWidget* parent = nullptr);

  const Target& target() const { return target_; }

  /// Accepts any kind but CoefficientRatio. Emits nothing.
  void setTarget(const Target& target);

  /// Sets what the current result achieves in each kind of target. Choosing a kind then asks for
  /// that value.
  void setAchieved(const std::map<Target::Kind, double>& achieved);

  /// Shows a warning below the number, with details as tool tip; empty: none.
  void setTrouble(const QString& trouble, const QString& details = {});

  QComboBox* kind() const { return kind_; }
  QSlider* slider() const { return slider_; }
  NumberBox* number() const { return value_; }
  QString trouble() const;

 signals:
  void targetChanged(const Target& target);

 private:
  void choose(const Target& target);
  void show();

  Target target_;
  std::map<Target::Kind, double> values_;  // value to ask for when a kind is chosen
  QComboBox* kind_;
  QSlider* slider_;
  NumberBox* value_;
  QLabel* trouble_;
};

}  // namespace mocapress
