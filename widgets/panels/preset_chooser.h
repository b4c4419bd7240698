// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/mocapress/settings.h"

class QComboBox;
class QMenu;
class QToolButton;

namespace mocapress {

/// Chooses a preset. Its menu saves, shares and removes the user's own presets. Shows what is set
/// and reports what the user wants.
class PresetChooser : public QWidget {
  Q_OBJECT

 public:
  explicit PresetChooser(QWidget* parent = nullptr);

  /// Sets the presets: built-in ones first, then the user's own.
  void setPresets(const std::vector<Settings>& presets);

  /// Sets the shown preset and emits nothing. A preset that differs from the one of the same name
  /// in the list is shown as modified; one without a name is shown as custom settings.
  void setPreset(const Settings& preset);

  /// True when the shown settings are exactly one of the presets.
  bool isPure() const;

  const Settings& preset() const { return preset_; }
  QComboBox* box() const { return box_; }
  QMenu* menu() const { return menu_; }

 signals:
  void chosen(const Settings& preset);
  void saveRequested(const Settings& preset);
  void renameRequested(const QString& name);
  void removeRequested(const QString& name);
  void importRequested();
  void exportRequested(const Settings& preset);

 private:
  void fillMenu(QToolButton* button);
  const Settings* known(const std::string& name) const;

  std::vector<Settings> all_;
  Settings preset_;
  QComboBox* box_;
  QMenu* menu_;
};

}  // namespace mocapress
