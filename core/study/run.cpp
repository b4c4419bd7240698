// SPDX-License-Identifier: MIT
#include "core/study/run.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/base/utf8_path.h"
#include "core/codec/methods/compression_method.h"
#include "core/mocapress/encode_settings.h"
#include "core/report/loaded_clip.h"

namespace mocapress {
namespace {

/// A clip that several jobs share. The first of them reads it and the last frees it, so that memory
/// holds only clips that are being compressed.
class SharedClip {
 public:
  explicit SharedClip(int jobs) : jobs_left_(jobs) {}

  /// Returns the clip. Null if it cannot be read; error() tells why.
  const LoadedClip* get(const StudyPlan& plan, const std::filesystem::path& path) {
    const std::lock_guard lock(mutex_);
    if (!clip_ && error_.empty()) {
      try {
        clip_ = std::make_unique<const LoadedClip>(
            read_motion_of_many(path, plan.skeleton, plan.reading));
        warnings_ = clip_->warnings();
      } catch (const std::exception& error) {
        error_ = error.what();
      }
    }
    return clip_.get();
  }

  void job_done() {
    const std::lock_guard lock(mutex_);
    if (--jobs_left_ == 0) clip_.reset();
  }

  const std::string& error() const { return error_; }
  const Warnings& warnings() const { return warnings_; }

 private:
  std::mutex mutex_;
  int jobs_left_;
  std::unique_ptr<const LoadedClip> clip_;
  Warnings warnings_;
  std::string error_;
};

class Run {
 public:
  Run(const StudyPlan& plan, std::span<const StudyRow> earlier, const RowSink& sink,
      const Observer<StudyProgress>& observer)
      : plan_(plan), sink_(sink), observer_(observer), jobs_(jobs_of(plan)), rows_(jobs_.size()) {
    std::vector<int> count(plan.clips.size(), 0);
    for (const StudyJob& job : jobs_) ++count[job.clip];
    for (const int jobs : count) clips_.push_back(std::make_unique<SharedClip>(jobs));
    for (const StudyRow& row : earlier) earlier_[row.key()] = &row;
    progress_.jobs = static_cast<int>(jobs_.size());
    const auto allowed =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    workers_ = std::min({tbb::this_task_arena::max_concurrency(), static_cast<int>(allowed),
                         std::max(1, progress_.jobs)});
  }

  StudyOutcome run() {
    // Takes jobs one by one in the plan's order, so that few clips are in memory.
    parallel_for(0, workers_, [this](int) {
      for (std::size_t job = next_++; job < jobs_.size() && !stopped_; job = next_++)
        // Isolated, so that a thread that waits within a job does not begin another job.
        tbb::this_task_arena::isolate([&] { do_job(job); });
    });
    StudyOutcome outcome;
    for (auto& row : rows_)
      if (row) outcome.rows.push_back(std::move(*row));
    outcome.complete = outcome.rows.size() == jobs_.size();
    for (const auto& clip : clips_)
      outcome.warnings.insert(outcome.warnings.end(), clip->warnings().begin(),
                              clip->warnings().end());
    return outcome;
  }

 private:
  void do_job(std::size_t index) {
    const StudyJob& job = jobs_[index];
    SharedClip& shared = *clips_[job.clip];
    StudyRow row{.clip = utf8(plan_.clips[job.clip].path),
                 .review = plan_.clips[job.clip].review,
                 .settings = settings_of(job),
                 .jobs = workers_};
    bool kept = false;
    bool complete = true;
    if (const LoadedClip* clip = shared.get(plan_, plan_.clips[job.clip].path)) {
      row.fingerprint = clip->fingerprint();
      kept = keep_earlier(row);
      if (!kept) complete = compress(*clip, row);
    } else {
      row.error = shared.error();
    }
    shared.job_done();
    if (complete) finish(index, std::move(row), kept);
  }

  Settings settings_of(const StudyJob& job) const {
    Settings settings = plan_.settings;
    settings.method = plan_.methods[job.method];
    settings.target = job.target;
    if (settings.method == name(Method::ClosedLoop)) settings.coding.reset();
    if (job.ik_ratio) settings.correction = CorrectionSettings{.ratio = job.ik_ratio};
    return settings;
  }

  bool keep_earlier(StudyRow& row) const {
    const auto found = earlier_.find(row.key());
    if (found == earlier_.end()) return false;
    StudyRow kept = *found->second;
    kept.clip = std::move(row.clip);  // the path may have changed since the earlier run
    kept.review = std::move(row.review);
    row = std::move(kept);
    return true;
  }

  /// Compresses and measures a clip. Returns false if the observer stopped it.
  bool compress(const LoadedClip& clip, StudyRow& row) {
    bool told_to_stop = false;
    try {
      check(row.settings);
      const Encoding encoding =
          clip.encoder().compress(*find_compression_method(row.settings.method),
                                  encode_settings(row.settings, clip.motion().skeleton),
                                  [&](const EncodeProgress&) { return !(told_to_stop = !ask()); });
      if (!encoding.complete) return false;
      row.measured = clip.measure(encoding);
    } catch (const std::bad_alloc&) {
      throw;  // not the clip's fault: later runs would keep it as a row
    } catch (const std::exception& error) {
      row.error = error.what();
    }
    return !told_to_stop;
  }

  bool ask() {
    const std::lock_guard lock(mutex_);
    progress_.finished = nullptr;
    return observe();
  }

  void finish(std::size_t index, StudyRow row, bool kept) {
    const std::lock_guard lock(mutex_);
    if (!kept && sink_) hand_over(row);
    rows_[index] = std::move(row);
    ++progress_.done;
    progress_.kept += kept;
    progress_.finished = &*rows_[index];
    observe();
  }

  void hand_over(const StudyRow& row) {
    try {
      sink_(row);
    } catch (...) {
      stopped_ = true;
      throw;
    }
  }

  bool observe() {
    if (!stopped_ && !should_continue(observer_, progress_)) stopped_ = true;
    return !stopped_;
  }

  const StudyPlan& plan_;
  const RowSink& sink_;
  const Observer<StudyProgress>& observer_;
  std::vector<StudyJob> jobs_;
  std::vector<std::unique_ptr<SharedClip>> clips_;
  std::unordered_map<std::string, const StudyRow*> earlier_;
  int workers_ = 1;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;  // guards the members below, and calls to the observer
  StudyProgress progress_;
  std::vector<std::optional<StudyRow>> rows_;
};

}  // namespace

StudyOutcome run_study(const StudyPlan& plan, std::span<const StudyRow> earlier,
                       const RowSink& sink, const Observer<StudyProgress>& observer) {
  return Run(plan, earlier, sink, observer).run();
}

}  // namespace mocapress
