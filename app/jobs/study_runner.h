// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/study/run.h"

namespace mocapress {

/// How far a study has come.
struct StudyCounts {
  int jobs = 0;
  int done = 0;
  int kept = 0;  // of those, measured by an earlier run
};

/// A study to run.
struct StudyTask {
  StudyPlan plan;
  QString folder;           // where its rows are kept
  bool with_files = false;  // write the tables and the report there as well
};

/// Runs a study in the background, the newest only, and hands over its rows as they are measured.
class StudyRunner : public QObject {
  Q_OBJECT

 public:
  explicit StudyRunner(QObject* parent = nullptr);

  /// Abandons a running one.
  void start(const StudyTask& task);

  /// What is done by then is handed over, and kept for the next run.
  void cancel() { runner_.stopEarly(); }

  /// As cancel(), and nothing is handed over any more.
  void abandon() { runner_.abandon(); }

  bool busy() const { return runner_.busy(); }

 signals:
  /// `rows` since the last time, in the order in which they were done.
  void advanced(const StudyCounts& counts, const std::vector<StudyRow>& rows);

  /// With all rows, in the order of the plan.
  void ended(const StudyOutcome& outcome);
  void failed(const QString& message);

 private:
  JobRunner runner_{Workers::LongRunning};
};

}  // namespace mocapress
