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

/// Chooses a preset and edits its most used settings. Shows what is set and reports what the user
/// chooses.
class PresetEditor : public QWidget {
  Q_OBJECT

 public:
  explicit PresetEditor(QWidget* parent = nullptr);

  /// Sets the presets to choose from: built-in ones first, then the user's own.
  void setPresets(const std::vector<Settings>& presets);

  /// Sets the edited preset and emits nothing. A preset that differs from the one of the same name
  /// in the list is shown as modified.
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
