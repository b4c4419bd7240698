// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/models/study_settings.h"

class QListWidget;
class QPushButton;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;

namespace mocapress {

class NumberListEdit;

/// The clips of a study: a list that takes dropped files and folders, and its buttons.
class StudyClips : public QWidget {
  Q_OBJECT

 public:
  explicit StudyClips(QWidget* parent = nullptr);

  void setClips(const QStringList& paths);

 signals:
  void addFilesRequested();
  void addFolderRequested();
  void dropped(const QStringList& paths);
  void removeRequested(const QStringList& paths);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void removeSelected();

  QListWidget* list_;
  QPushButton* remove_;
};

/// Edits a study's clips, methods and targets, and shows its progress.
class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void setSettings(const StudySettings& settings);

  /// Sets the folder that the study's rows are stored in; empty: the program's default.
  void setFolder(const QString& folder);

  /// `canRun` tells whether the study has work left.
  void setRunning(bool running, bool canRun);

  /// Shows how many jobs are done; `jobs` 0: their number is not known yet.
  void setProgress(int done, int jobs);

  void setStatus(const QString& status);

  StudyClips* clips() { return clips_; }
  QListWidget* methods() { return methods_; }
  QPushButton* runButton() { return run_; }

 signals:
  void settingsChanged(const StudySettings& settings);
  void folderRequested();
  void runRequested();
  void cancelRequested();

 private:
  QWidget* makeFeet();
  QWidget* makeTargets();
  void fillMethods();
  void change();

  StudySettings settings_;
  bool running_ = false;
  bool filling_ = false;
  StudyClips* clips_;
  QListWidget* methods_;
  QCheckBox* hold_feet_;
  QDoubleSpinBox* ik_ratio_;
  NumberListEdit* ratios_;
  NumberListEdit* errors_;
  QComboBox* weighting_;
  QPushButton* folder_;
  QPushButton* run_;
  QProgressBar* progress_;
  QLabel* status_;
};

}  // namespace mocapress
