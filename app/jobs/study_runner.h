// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/study/run.h"

namespace mocapress {

/// Progress of a study.
struct StudyCounts {
  int jobs = 0;
  int done = 0;
  int kept = 0;  // number of done jobs that an earlier run measured
};

/// A study to run.
struct StudyTask {
  StudyPlan plan;
  QString folder;           // folder of its rows
  bool with_files = false;  // tables and a report are written there, too
};

/// Runs the newest study in the background and hands over its rows as they are measured.
class StudyRunner : public QObject {
  Q_OBJECT

 public:
  explicit StudyRunner(QObject* parent = nullptr);

  /// Starts a study and abandons a running one.
  void start(const StudyTask& task);

  /// Stops the study; finished rows are handed over and kept for the next run.
  void cancel() { runner_.stopEarly(); }

  /// Like cancel(), but hands over nothing more.
  void abandon() { runner_.abandon(); }

  bool busy() const { return runner_.busy(); }

 signals:
  /// `rows` are new since the last time, in the order of completion.
  void advanced(const StudyCounts& counts, const std::vector<StudyRow>& rows);

  /// `outcome` has all rows, in the order of the plan.
  void ended(const StudyOutcome& outcome);
  void failed(const QString& message);

 private:
  JobRunner runner_{Workers::LongRunning};
};

}  // namespace mocapress
