// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

class QWidget;

namespace mocapress {

class BatchSession;
class BatchWindow;
class BlindTestWindow;
class ClipFiles;
class Library;
class PresetShelf;
class Session;
class StudySession;
class StudyWindow;

/// The windows for studies and batches. They are made on first use and live as long as the main
/// window.
class ToolWindows : public QObject {
  Q_OBJECT

 public:
  ToolWindows(Session* session, Library* library, ClipFiles* files, PresetShelf* presets,
              QWidget* window);

  /// Opens the study window or raises it.
  StudyWindow* showStudy();

  /// Shows the batch window and offers it the open clip.
  void showBatch();

  /// Shows the window of blind tests, on the open clip.
  BlindTestWindow* showBlindTest();

  /// Exports clips of the library with their own settings; no rows: all of them.
  void exportClips(const std::vector<int>& rows);

  /// True while a study, a batch or a blind test runs, which would end with the window.
  bool busy() const;

  void close();

 private:
  void makeStudy();
  void makeBatch();
  void keepWithProject(BatchSession* session);
  void showHere();

  Session* session_;
  Library* library_;
  ClipFiles* files_;
  PresetShelf* presets_;
  QWidget* window_;
  StudySession* study_session_ = nullptr;
  StudyWindow* study_ = nullptr;
  BatchWindow* batch_ = nullptr;
  BlindTestWindow* blind_test_ = nullptr;
};

}  // namespace mocapress
