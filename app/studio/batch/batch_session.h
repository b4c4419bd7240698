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

/// The queue of a batch export, its settings and its run. No widgets.
class BatchSession : public QObject {
  Q_OBJECT

 public:
  enum class State { Idle, Running, Paused, Stopping, Cancelling, Stopped, Complete, Failed };

  /// `presets` outlive it.
  explicit BatchSession(PresetShelf* presets, QObject* parent = nullptr);

  /// Takes up the batch of a project; nothing is left of the one before. Not while it runs.
  void recall(const RememberedBatch& batch);

  /// The state that the project keeps; keep() follows soon after each change.
  RememberedBatch remembered() const { return {settings_, queue_.common(), queue_.clips()}; }

  /// Says keep() now where it still waits to be said.
  void rememberNow();

  BatchQueueModel* queue() { return &queue_; }
  const BatchQueueModel* queue() const { return &queue_; }

  const BatchSettings& settings() const { return settings_; }

  /// These change nothing while it runs, and are steps of history(), as adding clips is.
  void setSettings(const BatchSettings& settings);
  void setCommon(const Settings& preset);
  void setOwn(const std::vector<int>& rows, const std::optional<Settings>& preset);
  void remove(const std::vector<int>& rows);
  void setLeftOut(const std::vector<int>& rows, bool left_out);

  /// What the library says, of clips that are added later too.
  void setReviews(const ClipReviews& reviews);

  /// What was done to the queue and its settings.
  const QUndoStack& history() const { return history_; }
  QUndoStack& history() { return history_; }

  /// Nothing while it runs.
  void undo();
  void redo();

  /// Files, and folders for all clips below them. While it runs, none: noted().
  void addClips(const QStringList& paths);

  /// Clips with the settings they were tuned by, which lock them; without any: as all others. Each
  /// keeps the character it was tuned on, unless the batch has one for all. While it runs, none:
  /// noted().
  void addTuned(const std::vector<TunedClip>& clips);

  PresetShelf* presets() const { return presets_; }

  /// The output of one of the clips; what is wrong with the names where `wrong` is set.
  QString exampleName(bool* wrong) const;

  /// Why it cannot start; empty: it can.
  QString obstacle() const;

  /// Does what is waiting and what failed; what was done before and has not changed is kept.
  void start();
  void pause();
  void goOn();
  void stopAfterCurrent();
  void cancel();

  State state() const { return state_; }
  bool running() const;
  const QString& failure() const { return failure_; }
  const BatchCounts& counts() const { return counts_; }

  /// The bank that is made when all clips have ended; unset before.
  const std::optional<BankProgress>& bank() const { return bank_; }

  /// 0 to 1, by the length of the clips.
  double fraction() const;
  const std::optional<double>& secondsLeft() const { return time_left_.seconds(); }

  /// Of the last run that ended with nothing waiting; empty: none is there.
  QString report() const;

  /// A script for Slurm that does this queue in so many tasks, and the queue's file beside it.
  void writeSlurm(const QString& path, int tasks);

 signals:
  /// The state that is remembered() has changed.
  void keep();

  void settingsChanged();

  /// The clip of this row, with what it came to.
  void exported(int row, const BatchStep& step);

  /// State, counts, or what may be started.
  void progressed();

  /// Worth telling, and no more than that.
  void noted(const QString& message);

 private:
  /// The clips that are not left out, and their rows in the queue.
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
  std::vector<int> running_rows_;  // by their indices in the batch that runs
  BatchSettings settings_;
  QUndoStack history_;
  PresetShelf* presets_;
  State state_ = State::Idle;
  QString failure_;
  BatchCounts counts_;
  std::optional<BankProgress> bank_;
  TimeLeft time_left_;
  QElapsedTimer clock_;
  double worked_seconds_ = 0;  // before the last pause
  QTimer remember_later_;
  QStringList to_find_;
  JobRunner finding_{Workers::LongRunning};
  std::vector<TunedClip> to_fit_;
  JobRunner fitting_{Workers::LongRunning};
  BatchRunner runner_;
};

}  // namespace mocapress
