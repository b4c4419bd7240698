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

/// What is asked for, a size or a quality, on a slider of equal factors with a number beside it.
/// The number may lie beyond the slider and beyond what the clip can reach: it stays as typed.
class TargetControl : public QWidget {
  Q_OBJECT

 public:
  explicit TargetControl(QWidget* parent = nullptr);

  const Target& target() const { return target_; }

  /// Of any kind but CoefficientRatio. Emits nothing.
  void setTarget(const Target& target);

  /// What the current result has of each kind: that is asked for when the kind is chosen.
  void setAchieved(const std::map<Target::Kind, double>& achieved);

  /// Said below the number, with more about it as a tool tip; empty: nothing is wrong.
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
  std::map<Target::Kind, double> values_;  // what each kind begins with when it is chosen
  QComboBox* kind_;
  QSlider* slider_;
  NumberBox* value_;
  QLabel* trouble_;
};

}  // namespace mocapress
