// SPDX-License-Identifier: MIT
#include "core/batch/run.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <set>

#include "core/base/number_text.h"
#include "core/base/open_file.h"
#include "core/base/parallel.h"
#include "core/base/utf8_path.h"

namespace mocapress {

void BatchControl::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
}

void BatchControl::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  changed_.notify_all();
}

void BatchControl::stop_after_current() {
  wish(Wish::StopAfterCurrent);
}

void BatchControl::cancel() {
  wish(Wish::Cancel);
}

void BatchControl::wish(Wish wish) {
  const std::lock_guard lock(mutex_);
  wish_ = std::max(wish_, wish);
  paused_ = false;  // workers that wait must run to stop
  changed_.notify_all();
}

bool BatchControl::paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

bool BatchControl::cancelled() const {
  const std::lock_guard lock(mutex_);
  return wish_ == Wish::Cancel;
}

bool BatchControl::may_begin() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !paused_; });
  return wish_ == Wish::GoOn;
}

bool BatchControl::may_continue() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !paused_; });
  return wish_ != Wish::Cancel;
}

namespace {

namespace fs = std::filesystem;

std::uint64_t size_of(const BatchItem& item) {
  const std::optional<FileStatus> found = status_of(utf8_path(item.input));
  return found ? found->size : 0;
}

int workers_for(int jobs) {
  const auto allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int processors =
      std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(allowed));
  return jobs > 0 ? std::min(jobs, processors) : processors;
}

/// The time spent on one clip, without pauses.
class ClipTime {
 public:
  explicit ClipTime(std::optional<double> limit_seconds) : limit_(limit_seconds) {}

  bool is_over() const { return limit_ && Clock::now() - start_ > Seconds(*limit_); }

  /// Calls wait() and returns its result. Its time does not count.
  template <typename Wait>
  bool without(Wait wait) {
    const Clock::time_point before = Clock::now();
    const bool result = wait();
    start_ += Clock::now() - before;
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  std::optional<double> limit_;
  Clock::time_point start_ = Clock::now();
};

class Run {
 public:
  Run(const Batch& batch, const fs::path& folder, Journal& journal, const BatchRunOptions& options,
      BatchControl& control, const Observer<BatchProgress>& observer)
      : batch_(batch),
        folder_(folder),
        journal_(journal),
        options_(options),
        control_(control),
        observer_(observer) {
    queue_.reserve(batch.items.size());
    for (std::size_t i = 0; i < batch.items.size(); ++i)
      if (const BatchItem item = batch.items[i]; options.shard.has(item))
        queue_.push_back({i, size_of(item)});
    sources_ = source_files(batch);
    for (const Waiting& clip : queue_) counts_.bytes += clip.bytes;
    counts_.clips = queue_.size();
    // The largest clips come first: a long clip at the end would leave the other threads idle.
    if (options.largest_first)
      std::ranges::stable_sort(
          queue_, [](const Waiting& a, const Waiting& b) { return a.bytes > b.bytes; });
  }

  BatchOutcome run() {
    const int workers = workers_for(options_.jobs);
    tbb::task_arena arena(workers);
    arena.execute([&] {
      parallel_for(0, workers, [this](int) {
        while (control_.may_begin()) {
          const std::size_t next = next_++;
          if (next >= queue_.size()) return;
          // Isolated, so that a thread that waits within a clip does not begin another clip.
          tbb::this_task_arena::isolate([&] { do_clip(queue_[next]); });
        }
      });
    });
    if (failure_) std::rethrow_exception(failure_);
    return {counts_, counts_.done == counts_.clips, {}};
  }

 private:
  struct Waiting {
    std::size_t index;
    std::uint64_t bytes;
  };

  /// Does one clip. If the clip fails, its row says so; if the journal cannot be read or written,
  /// the run ends.
  void do_clip(const Waiting& clip) try {
    const BatchItem item = batch_.items[clip.index];
    const std::optional<BatchRow> earlier = find(clip.index);
    if (earlier && options_.resumed && still_done(*earlier, batch_, item, folder_)) {
      const bool judges = earlier->preset.limits != batch_.presets[item.preset].limits;
      std::optional<BatchRow> kept =
          judges ? judged_again(*earlier, batch_, clip.index, folder_, characters_) : earlier;
      if (kept) {
        kept->review = item.review;
        return finish(clip, *kept, true, judges || earlier->review != item.review);
      }
    }
    const ExportRights rights{.overwrite = options_.overwrite,
                              .resumed = options_.resumed,
                              .earlier = earlier ? &*earlier : nullptr,
                              .sources = &sources_};
    ClipTime time(options_.clip_seconds);
    auto row = export_clip(batch_, clip.index, folder_, rights, characters_,
                           [&](const ClipProgress& progress) {
                             if (time.is_over()) return false;
                             if (!time.without([&] { return control_.may_continue(); }))
                               return false;
                             return tell(clip, progress);
                           });
    if (!row && time.is_over() && !control_.cancelled())
      row = failed_row(batch_, clip.index,
                       "took longer than " + shortest_text(*options_.clip_seconds) + " s");
    if (row)
      finish(clip, *row, false, true);
    else
      drop(clip);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    control_.cancel();
  }

  std::optional<BatchRow> find(std::size_t index) {
    const std::lock_guard lock(mutex_);
    return journal_.find(index);
  }

  void finish(const Waiting& clip, const BatchRow& row, bool kept, bool is_new) {
    const std::lock_guard lock(mutex_);
    if (is_new) journal_.append(row);
    set_under_way(clip, 0);
    ++counts_.done;
    counts_.kept += kept;
    counts_.failed += !row.done();
    counts_.bytes_done += clip.bytes;
    if (kept) counts_.bytes_kept += clip.bytes;
    if (!row.done() && !options_.keep_going) control_.cancel();
    BatchProgress step;
    step.index = clip.index;
    step.row = &row;
    step.kept = kept;
    observe(step);
  }

  bool tell(const Waiting& clip, const ClipProgress& progress) {
    const std::lock_guard lock(mutex_);
    set_under_way(clip, progress.fraction);
    BatchProgress step;
    step.index = clip.index;
    step.clip = progress;
    return observe(step);
  }

  /// Makes a clip wait again, since it was stopped.
  void drop(const Waiting& clip) {
    const std::lock_guard lock(mutex_);
    set_under_way(clip, 0);
  }

  void set_under_way(const Waiting& clip, double fraction) {
    under_way_[clip.index] = fraction * static_cast<double>(clip.bytes);
    if (fraction == 0) under_way_.erase(clip.index);
    counts_.bytes_under_way = 0;
    for (const auto& [index, bytes] : under_way_) counts_.bytes_under_way += bytes;
  }

  bool observe(BatchProgress& step) {
    step.counts = counts_;
    if (should_continue(observer_, step)) return true;
    control_.cancel();
    return false;
  }

  const Batch& batch_;
  const fs::path& folder_;
  Journal& journal_;
  const BatchRunOptions& options_;
  BatchControl& control_;
  const Observer<BatchProgress>& observer_;
  std::vector<Waiting> queue_;
  std::set<FileIdentity> sources_;
  SharedCharacters characters_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;  // guards the members below, the journal and calls to the observer
  BatchCounts counts_;
  std::map<std::size_t, double> under_way_;  // bytes done, by the clip's index
  std::exception_ptr failure_;
};

}  // namespace

BatchOutcome run_batch(const Batch& batch, const fs::path& folder, Journal& journal,
                       const BatchRunOptions& options, BatchControl& control,
                       const Observer<BatchProgress>& observer) {
  return Run(batch, folder, journal, options, control, observer).run();
}

void TimeLeft::update(const BatchCounts& counts, double elapsed_seconds) {
  const bool has_ended = counts.done != done_;
  done_ = counts.done;
  if (counts.done == counts.kept) {
    seconds_.reset();
    return;
  }
  const double done = static_cast<double>(counts.bytes_done) + counts.bytes_under_way;
  const double worked = done - static_cast<double>(counts.bytes_kept);
  if (!(worked > 0)) return;  // all files are empty
  const double now = elapsed_seconds * (static_cast<double>(counts.bytes) - done) / worked;
  seconds_ = has_ended || !seconds_ ? now : std::min(*seconds_, now);
}

}  // namespace mocapress
