// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/mocapress/settings.h"

class QWidget;

namespace mocapress {

class PresetChooser;
class PresetShelf;
class Session;

/// Connects what is common to every chooser of presets: renaming, removing, import and export, with
/// their dialogs over `window`. Choosing and saving are its owner's.
void connectShelf(PresetChooser* chooser, PresetShelf* shelf, QWidget* window);

/// The preset under a name that is asked for; without a name: the user thought better of it.
Settings askForName(const Settings& preset, QWidget* window);

/// Keeps a chooser showing what preset the clip's settings are, and passes on what is done in it.
class PresetViews : public QObject {
  Q_OBJECT

 public:
  PresetViews(Session* session, PresetShelf* shelf, PresetChooser* chooser, QWidget* window);

  /// The settings of the clip, kept under a name which they have from then on.
  void save(const Settings& preset);

 private:
  void showPresets();
  void showSettings();

  Session* session_;
  PresetShelf* shelf_;
  PresetChooser* chooser_;
};

}  // namespace mocapress
