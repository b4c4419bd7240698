// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <QWidget>

#include "app/studio/batch/batch_session.h"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace mocapress {

class BatchOutput;
class BatchQueueView;
class BatchSession;
class CharacterChoice;
class PresetEditor;

/// The batch's progress in one line.
QString statusOf(const BatchSession& session);

/// Text of the button that starts, pauses and resumes.
QString startText(const BatchSession& session);

/// The window of the batch: its queue, presets, output and progress. Closing the window does not
/// stop the batch.
class BatchWindow : public QWidget {
  Q_OBJECT

 public:
  BatchWindow(BatchSession* session, QWidget* parent);

  /// Offers the open clip for export, unless the user chose others.
  void offer(const std::vector<TunedClip>& clips);

  BatchSession* session() { return session_; }
  BatchQueueView* view() { return view_; }
  PresetEditor* editor() { return editor_; }
  CharacterChoice* character() { return character_; }
  BatchOutput* output() { return output_; }
  QPushButton* startButton() { return start_; }
  QPushButton* reportButton() { return report_; }

 signals:
  /// Asks the studio to open a clip.
  void openRequested(const QString& path);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QAction* makeStep(QAction* step, QKeySequence::StandardKey key, const QString& icon,
                    QHBoxLayout* tools);
  QWidget* makeQueue();
  QWidget* makeSettings();
  QWidget* makeFoot();
  void connectSession();
  void connectQueue();
  void connectPresets();
  void chooseFiles();
  void chooseClipFolder();
  void chooseFolder();
  void chooseCharacter();
  void putCharacter(const QString& path);
  void savePreset(const Settings& preset);
  void writeSlurm();
  void changePreset(const Settings& preset);
  void showSelection();
  void showOutput();
  void showProgress();

  BatchSession* session_;
  BatchQueueView* view_;
  PresetEditor* editor_;
  CharacterChoice* character_;
  BatchOutput* output_;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QWidget* settings_ = nullptr;
  QLabel* whose_;
  QPushButton* unlock_;
  QPushButton* start_;
  QPushButton* stop_;
  QPushButton* cancel_;
  QPushButton* report_;
  QPushButton* slurm_;
  QProgressBar* progress_;
  QLabel* status_;
  QLabel* note_;
};

}  // namespace mocapress
