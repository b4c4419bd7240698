// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/batch/preset.h"

class QComboBox;
class QMenu;
class QToolButton;

namespace mocapress {

/// The presets to choose from, and a menu to keep, share and remove one's own. Shows what it is
/// told, and tells what the user wants.
class PresetChooser : public QWidget {
  Q_OBJECT

 public:
  explicit PresetChooser(QWidget* parent = nullptr);

  /// Built-in ones first, then the user's own.
  void setPresets(const std::vector<Preset>& presets);

  /// Emits nothing. One that is not among the presets is shown as a change of the one whose name it
  /// has; without a name, as settings of its own.
  void setPreset(const Preset& preset);

  /// Whether what is shown is one of the presets as it is.
  bool isPure() const;

  const Preset& preset() const { return preset_; }
  QComboBox* box() const { return box_; }
  QMenu* menu() const { return menu_; }

 signals:
  void chosen(const Preset& preset);
  void saveRequested(const Preset& preset);
  void renameRequested(const QString& name);
  void removeRequested(const QString& name);
  void importRequested();
  void exportRequested(const Preset& preset);

 private:
  void fillMenu(QToolButton* button);
  const Preset* known(const std::string& name) const;

  std::vector<Preset> all_;
  Preset preset_;
  QComboBox* box_;
  QMenu* menu_;
};

}  // namespace mocapress
