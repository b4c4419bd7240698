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

/// Keeps the panel of the library and the two settings showing what there is, and passes on what is
/// done in them.
class LibraryViews : public QObject {
  Q_OBJECT

 public:
  LibraryViews(Session* session, Library* library, LibraryPanel* panel, SlotControl* settings,
               QWidget* window);

  /// Those that can be chosen for clips of the library.
  void offer(const PresetShelf* presets);

  /// With a file dialog.
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
