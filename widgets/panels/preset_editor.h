// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/mocapress/settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace mocapress {

class PresetChooser;

/// A preset to choose, and the few settings most are changed in. Shows what it is told, and tells
/// what the user chose.
class PresetEditor : public QWidget {
  Q_OBJECT

 public:
  explicit PresetEditor(QWidget* parent = nullptr);

  /// Those to choose from: built-in ones first, then the user's own.
  void setPresets(const std::vector<Settings>& presets);

  /// Emits nothing. One that is not among the presets is shown as a change of the one whose name it
  /// has.
  void setPreset(const Settings& preset);

  PresetChooser* chooser() const { return chooser_; }
  QComboBox* kind() const { return kind_; }
  QDoubleSpinBox* value() const { return value_; }
  QComboBox* weighting() const { return weighting_; }
  QCheckBox* holdFeet() const { return hold_feet_; }

 signals:
  void presetChanged(const Settings& preset);

 private:
  void addRows();
  void change();
  void showKind();

  Settings preset_;
  bool filling_ = false;
  PresetChooser* chooser_;
  QLabel* purpose_;
  QComboBox* kind_;
  QDoubleSpinBox* value_;
  QComboBox* method_;
  QComboBox* weighting_;
  QCheckBox* hold_feet_;
};

}  // namespace mocapress
