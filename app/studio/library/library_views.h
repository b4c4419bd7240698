// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/report/review.h"

class QWidget;

namespace mocapress {

class BackgroundEncoding;
class Library;
class LibraryPanel;
class LibraryPlot;
class PresetShelf;
class Session;
class SlotControl;

/// Shows the library, and the settings A and B, in their panels, and passes the user's actions on.
class LibraryViews : public QObject {
  Q_OBJECT

 public:
  LibraryViews(Session* session, Library* library, LibraryPanel* panel, SlotControl* settings,
               QWidget* window);

  /// Sets the presets that clips of the library can get.
  void offer(const PresetShelf* presets);

  /// Opens clips that are clicked in the plot.
  void offer(LibraryPlot* plot);

  /// Opens the next clip that waits for a verdict; shows a message if there is none.
  void showNextToReview();

  /// Gives the open clip a verdict and opens the next that waits for one.
  void judge(Verdict verdict);

  /// Asks for files and adds them.
  void addClips();
  void addFolder();
  void findMissing();

  /// True if clips are compressed in the background.
  bool encodes() const;
  void setEncodes(bool encodes);

  /// Asks for an earlier batch or project, and compares the library with it.
  void compareWithBatch();

 private:
  void putCharacter(const std::vector<int>& rows);
  void showComparison();
  void showSlots();

  Session* session_;
  Library* library_;
  LibraryPanel* panel_;
  SlotControl* slots_;
  BackgroundEncoding* encoding_;
  QWidget* window_;
};

}  // namespace mocapress
