// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/mocapress/settings.h"

class QWidget;

namespace mocapress {

class PresetChooser;
class PresetShelf;
class Session;

/// Connects the actions common to all preset choosers: renaming, removing, import and export, with
/// dialogs over `window`. The owner handles choosing and saving.
void connectShelf(PresetChooser* chooser, PresetShelf* shelf, QWidget* window);

/// Asks for a name for the preset; the name is empty if the user cancelled.
Settings askForName(const Settings& preset, QWidget* window);

/// Shows the preset of the clip's settings in a chooser, and passes the user's actions on.
class PresetViews : public QObject {
  Q_OBJECT

 public:
  PresetViews(Session* session, PresetShelf* shelf, PresetChooser* chooser, QWidget* window);

  /// Saves the clip's settings as a preset and gives them its name.
  void save(const Settings& preset);

 private:
  void showPresets();
  void showSettings();

  Session* session_;
  PresetShelf* shelf_;
  PresetChooser* chooser_;
};

}  // namespace mocapress
