// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/study_runner.h"

#include <chrono>

#include "core/study/study_folder.h"

namespace mocapress {
namespace {

/// Collects rows, since an earlier run may deliver thousands at once.
class RowReporter {
 public:
  using Send = std::function<void(const StudyCounts&, std::vector<StudyRow>)>;

  explicit RowReporter(Send send) : send_(std::move(send)) {}

  void add(const StudyProgress& progress) {
    if (progress.finished) rows_.push_back(*progress.finished);
    counts_ = {progress.jobs, progress.done, progress.kept};
    if (!rows_.empty() && std::chrono::steady_clock::now() - sent_ >= kReportInterval) flush();
  }

  void flush() {
    send_(counts_, std::exchange(rows_, {}));
    sent_ = std::chrono::steady_clock::now();
  }

 private:
  Send send_;
  StudyCounts counts_;
  std::vector<StudyRow> rows_;
  std::chrono::steady_clock::time_point sent_;
};

}  // namespace

StudyRunner::StudyRunner(QObject* parent) : QObject(parent) {}

void StudyRunner::start(const StudyTask& task) {
  const auto work = [this, task](const Job& job) {
    RowReporter reporter([&](const StudyCounts& counts, std::vector<StudyRow> rows) {
      job.post([this, counts, rows = std::move(rows)] { emit advanced(counts, rows); });
    });
    const auto observer = [&](const StudyProgress& progress) {
      reporter.add(progress);
      return !job.stopRequested();
    };
    const std::filesystem::path folder = task.folder.toStdU16String();
    StudyOutcome outcome = task.with_files ? run_study_in(folder, task.plan, observer)
                                           : run_study_kept(folder, task.plan, observer);
    reporter.flush();
    return outcome;
  };
  runner_.start(
      work, [this](const StudyOutcome& outcome) { emit ended(outcome); },
      [this](const QString& message) { emit failed(message); });
}

}  // namespace mocapress
