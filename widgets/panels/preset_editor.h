// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/batch/preset.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace mocapress {

/// A preset to choose, and the few settings most are changed in. Shows what it is told, and tells
/// what the user chose.
class PresetEditor : public QWidget {
  Q_OBJECT

 public:
  explicit PresetEditor(QWidget* parent = nullptr);

  /// Those to choose from: built-in ones first, then the user's own.
  void setPresets(const std::vector<Preset>& presets);

  /// Emits nothing. One that is not among the presets is shown as a change of the one whose name it
  /// has.
  void setPreset(const Preset& preset);

  QComboBox* presets() const { return presets_; }
  QComboBox* kind() const { return kind_; }
  QDoubleSpinBox* value() const { return value_; }
  QCheckBox* holdFeet() const { return hold_feet_; }

 signals:
  void presetChanged(const Preset& preset);
  void saveRequested(const Preset& preset);
  void removeRequested(const QString& name);
  void importRequested();
  void exportRequested(const Preset& preset);

 private:
  void addRows();
  QToolButton* makeMenu();
  void choosePreset(int index);
  void change();
  void showKind();
  const Preset* known(const std::string& name) const;

  std::vector<Preset> all_;
  Preset preset_;
  bool filling_ = false;
  QComboBox* presets_;
  QLabel* purpose_;
  QComboBox* kind_;
  QDoubleSpinBox* value_;
  QComboBox* method_;
  QCheckBox* hold_feet_;
};

}  // namespace mocapress
