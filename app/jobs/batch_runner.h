// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/batch/batch_folder.h"

namespace mocapress {

/// A batch to run.
struct BatchTask {
  Batch batch;
  QString folder;
  BatchRunOptions options;
};

/// News about one clip: its end or its progress.
struct BatchStep {
  std::size_t index = 0;
  bool ended = false;
  ClipProgress progress;
  std::string source;  // hash of its input files; set at its end
  std::optional<Measurement> measured;
  std::string error;
  std::vector<std::string> warnings;
  std::string worst_point;  // the landmark with the largest error; empty: not measured
};

/// Runs a batch in the background and reports on its clips.
class BatchRunner : public QObject {
  Q_OBJECT

 public:
  explicit BatchRunner(QObject* parent = nullptr);
  ~BatchRunner() override;

  /// Does nothing while a batch is running.
  void start(BatchTask task);

  void pause();
  void goOn();
  void stopAfterCurrent();
  void cancel();

  bool busy() const { return runner_.busy(); }

 signals:
  /// Reports the changes since the last signal: for each clip only the newest step.
  void advanced(const BatchCounts& counts, const std::vector<BatchStep>& steps);
  /// Emitted after all clips have ended, while their bank is being made.
  void bankAdvanced(const BankProgress& bank);
  void ended(const BatchOutcome& outcome);
  void failed(const QString& message);

 private:
  std::shared_ptr<BatchControl> control_;
  JobRunner runner_{Workers::LongRunning};
};

}  // namespace mocapress
