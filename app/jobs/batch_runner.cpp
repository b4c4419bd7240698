// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/batch_runner.h"

#include <chrono>
#include <map>

namespace mocapress {
namespace {

/// Collects news before sending it, since thousands of clips may report at once.
class BatchReporter {
 public:
  using Send = std::function<void(const BatchCounts&, std::vector<BatchStep>)>;
  using SendBank = std::function<void(const BankProgress&)>;

  BatchReporter(Send send, SendBank send_bank)
      : send_(std::move(send)), send_bank_(std::move(send_bank)) {}

  void add(const BatchProgress& progress) {
    if (progress.bank) return add(*progress.bank);
    BatchStep& step = steps_[progress.index];
    step.index = progress.index;
    step.progress = progress.clip;
    if (progress.row) {
      step.ended = true;
      step.source = progress.row->stamp.source;
      step.measured = progress.row->measured;
      step.error = progress.row->error;
      step.warnings = progress.row->warnings;
      step.worst_point = progress.row->worst ? progress.row->worst->landmark : std::string();
    }
    counts_ = progress.counts;
    if (std::chrono::steady_clock::now() - sent_ >= kReportInterval) flush();
  }

  void add(const BankProgress& bank) {
    if (!steps_.empty()) flush();
    const auto now = std::chrono::steady_clock::now();
    if (is_at_bank_ && now - sent_ < kReportInterval) return;
    is_at_bank_ = true;
    send_bank_(bank);
    sent_ = now;
  }

  void flush() {
    std::vector<BatchStep> steps;
    for (auto& [index, step] : steps_) steps.push_back(std::move(step));
    steps_.clear();
    send_(counts_, std::move(steps));
    sent_ = std::chrono::steady_clock::now();
  }

 private:
  Send send_;
  SendBank send_bank_;
  bool is_at_bank_ = false;
  BatchCounts counts_;
  std::map<std::size_t, BatchStep> steps_;
  std::chrono::steady_clock::time_point sent_;
};

}  // namespace

BatchRunner::BatchRunner(QObject* parent) : QObject(parent) {}

/// cancel() also resumes a paused batch, which would never end otherwise.
BatchRunner::~BatchRunner() {
  cancel();
}

void BatchRunner::start(BatchTask task) {
  if (busy()) return;
  control_ = std::make_shared<BatchControl>();
  const auto work = [this, task = std::move(task), control = control_](const Job& job) {
    BatchReporter reporter(
        [&](const BatchCounts& counts, std::vector<BatchStep> steps) {
          job.post([this, counts, steps = std::move(steps)] { emit advanced(counts, steps); });
        },
        [&](const BankProgress& bank) { job.post([this, bank] { emit bankAdvanced(bank); }); });
    const std::filesystem::path folder = task.folder.toStdU16String();
    const BatchOutcome outcome =
        run_batch_in(folder, task.batch, task.options, *control, [&](const BatchProgress& step) {
          reporter.add(step);
          return !job.stopRequested();
        });
    reporter.flush();
    return outcome;
  };
  runner_.start(
      work, [this](const BatchOutcome& outcome) { emit ended(outcome); },
      [this](const QString& message) { emit failed(message); });
}

void BatchRunner::pause() {
  if (busy()) control_->pause();
}

void BatchRunner::goOn() {
  if (control_) control_->resume();
}

void BatchRunner::stopAfterCurrent() {
  if (control_) control_->stop_after_current();
}

void BatchRunner::cancel() {
  if (control_) control_->cancel();
}

}  // namespace mocapress
