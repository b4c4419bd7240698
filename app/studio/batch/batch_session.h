// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>
#include <optional>
#include <vector>

#include "app/jobs/batch_runner.h"
#include "app/jobs/job_runner.h"
#include "app/studio/batch/batch_memory.h"
#include "app/studio/document/named_settings.h"
#include "core/batch/run.h"
#include "widgets/models/batch_queue_model.h"

namespace mocapress {

class PresetShelf;

/// Makes a clip for the queue. If its settings name joints, reads the clip to leave out those that
/// it lacks. If reading fails, the batch reports the error later.
QueuedClip queuedClip(const TunedClip& clip);

/// The queue of a batch export, its settings and its run. No widgets.
class BatchSession : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Running, Paused, Stopping, Cancelling, Stopped, Complete, Failed };

  /// `presets` must outlive the session.
  explicit BatchSession(PresetShelf* presets, QObject* parent = nullptr);

  /// Loads a project's batch and drops the previous one. Not allowed while a batch runs.
  void recall(const RememberedBatch& batch);

  /// The state that the project saves; keep() follows soon after each change.
  RememberedBatch remembered() const { return {settings_, queue_.common(), queue_.clips()}; }

  /// Emits keep() now if it is still pending.
  void rememberNow();

  BatchQueueModel* queue() { return &queue_; }
  const BatchQueueModel* queue() const { return &queue_; }

  const BatchSettings& settings() const { return settings_; }

  /// Changes settings, as steps of history(). Does nothing while a batch runs.
  void setSettings(const BatchSettings& settings);
  void setCommon(const Settings& preset);
  void setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset);
  void remove(const std::vector<int>& rows);
  void setLeftOut(const std::vector<int>& rows, bool left_out);

  /// Sets the library's reviews, which apply to clips added later too.
  void setReviews(const ClipReviews& reviews);

  /// The undo history of the queue and its settings.
  const QUndoStack& history() const { return history_; }
  QUndoStack& history() { return history_; }

  /// Does nothing while a batch runs.
  void undo();
  void redo();

  /// Adds files, and all clips below folders. A running batch refuses with noted().
  void addClips(const QStringList& paths);

  /// Adds clips locked to the settings they were tuned with; clips without settings use the common
  /// preset. Each keeps its character, unless the batch has one for all. A running batch refuses
  /// with noted().
  void addTuned(const std::vector<TunedClip>& clips);

  PresetShelf* presets() const { return presets_; }

  /// The output name of one of the clips. If the pattern for names is wrong, sets `wrong` and
  /// returns the error.
  QString exampleName(bool* wrong) const;

  /// The reason why the batch cannot start; empty: it can.
  QString obstacle() const;

  /// Exports waiting and failed clips. Finished clips that have not changed are kept.
  void start();
  void pause();
  void goOn();
  void stopAfterCurrent();
  void cancel();

  State state() const { return state_; }
  bool running() const;
  const QString& failure() const { return failure_; }
  const BatchCounts& counts() const { return counts_; }

  /// Progress of the bank, which is made after all clips have ended; unset before.
  const std::optional<BankProgress>& bank() const { return bank_; }

  /// The part of the batch that is done, from 0 to 1, by the clips' lengths.
  double fraction() const;
  const std::optional<double>& secondsLeft() const { return time_left_.seconds(); }

  /// Report of the last run that completed; empty if there is none.
  QString report() const;

  /// Writes a Slurm script that exports this queue in `tasks` tasks, with the queue's file beside
  /// it.
  void writeSlurm(const QString& path, int tasks);

 signals:
  /// The state in remembered() has changed.
  void keep();

  void settingsChanged();

  /// The clip of this row was exported with this result.
  void exported(int row, const BatchStep& step);

  /// The state, the counts or obstacle() has changed.
  void progressed();

  /// A message for the user that needs no answer.
  void noted(const QString& message);

 private:
  /// The clips to export, without those that the user left out, and their rows in the queue.
  Batch batch() const;
  std::vector<int> includedRows() const;
  QueuedClip reviewed(QueuedClip clip) const;
  bool refused();
  void apply(const BatchSettings& settings);
  void add(const std::vector<QueuedClip>& clips);
  void take(const std::vector<QueuedClip>& clips);
  void setState(State state, const QString& failure = {});
  void advance(const BatchCounts& counts, const std::vector<BatchStep>& steps);
  void end(const BatchOutcome& outcome);

  BatchQueueModel queue_;
  ClipReviews reviews_;
  std::vector<int> running_rows_;  // queue rows of the running batch's clips
  BatchSettings settings_;
  QUndoStack history_;
  PresetShelf* presets_;
  State state_ = State::Idle;
  QString failure_;
  BatchCounts counts_;
  std::optional<BankProgress> bank_;
  TimeLeft time_left_;
  QElapsedTimer clock_;
  double worked_seconds_ = 0;  // time worked before the last pause
  QTimer remember_later_;
  QStringList to_find_;
  JobRunner finding_{Workers::LongRunning};
  std::vector<TunedClip> to_fit_;
  JobRunner fitting_{Workers::LongRunning};
  BatchRunner runner_;
};

}  // namespace mocapress
