// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace mocapress {

class Library;
class LibraryPanel;
class PresetShelf;
class Session;
class SlotControl;

/// Shows the library and both settings in their panels, and passes the user's actions on.
class LibraryViews : public QObject {
  Q_OBJECT

 public:
  LibraryViews(Session* session, Library* library, LibraryPanel* panel, SlotControl* settings,
               QWidget* window);

  /// Sets the presets that clips of the library can get.
  void offer(const PresetShelf* presets);

  /// Asks for files.
  void addClips();
  void addFolder();
  void findMissing();

 private:
  void showSlots();

  Session* session_;
  Library* library_;
  LibraryPanel* panel_;
  SlotControl* slots_;
  QWidget* window_;
};

}  // namespace mocapress
