// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/batch/clip_export.h"
#include "core/batch/journal.h"
#include "core/report/report_language.h"

namespace mocapress {

/// Commands to a running batch, from any thread.
class BatchControl {
 public:
  /// Makes workers stop at their next check and wait.
  void pause();
  void resume();

  /// Lets workers finish their clips but not begin others.
  void stop_after_current();

  /// Makes workers abandon their clips, which then wait for another run.
  void cancel();

  bool paused() const;
  bool cancelled() const;

  /// Workers call may_begin() before each clip and may_continue() during a clip. Both wait while
  /// the batch is paused.
  bool may_begin();
  bool may_continue();

 private:
  enum class Wish { GoOn, StopAfterCurrent, Cancel };

  void wish(Wish wish);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false;
  Wish wish_ = Wish::GoOn;
};

struct BatchCounts {
  std::size_t clips = 0;  // in this shard
  std::size_t done = 0;   // clips that ended, whether done or failed
  std::size_t kept = 0;   // those among `done` that come from an earlier run
  std::size_t failed = 0;
  std::uint64_t bytes = 0;  // size of the clips' files; remaining time is estimated from it
  std::uint64_t bytes_done = 0;
  std::uint64_t bytes_kept = 0;
  double bytes_under_way = 0;  // of the clips being worked on: size times the share that is done
};

/// A step in the work on one clip, or on the bank made of all clips.
struct BatchProgress {
  BatchCounts counts;
  std::optional<BankProgress> bank;  // if set, the members below are unused
  std::size_t index = 0;             // clip's index in the batch
  ClipProgress clip;                 // valid until the clip has ended
  const BatchRow* row = nullptr;     // set once the clip has ended
  bool kept = false;                 // true: the row comes from an earlier run
};

struct BatchRunOptions {
  Shard shard;
  int jobs = 0;  // number of clips at a time; 0: one for each processor
  bool overwrite = false;
  bool resumed = false;
  bool keep_going = true;                   // false: the first failure ends the run
  std::optional<double> clip_seconds = {};  // time limit for a clip; unset: none
  bool largest_first = true;                // false: in the order of the batch
  bool take_over = false;        // true: takes over the journal of a run on another computer
  ReportLanguage language = {};  // the page's language
};

struct BatchOutcome {
  BatchCounts counts;
  bool complete = true;  // false: some clips are still waiting
  Warnings warnings;     // about journal and bank; a clip's are in its row
  bool has_bank = false;
};

/// Does the clips of a shard; writes their files into `folder`. Each clip takes one thread while
/// others wait, so memory holds one clip for each thread. A clip's row is in the journal before its
/// worker begins the next clip. The observer is called by one thread at a time. If the observer
/// returns false, or if `control` says so, clips that are not done wait for another run. Throws
/// WriteError if the journal cannot be written; all other failures are in the rows.
BatchOutcome run_batch(const Batch& batch, const std::filesystem::path& folder, Journal& journal,
                       const BatchRunOptions& options, BatchControl& control,
                       const Observer<BatchProgress>& observer = {});

/// Estimates the remaining time of a running batch from its speed so far. Between two ends of clips
/// the estimate never grows, since progress within a clip is a guess and a long clip says nothing
/// about the others.
class TimeLeft {
 public:
  /// To be called at every step of the batch. `elapsed_seconds` does not include pauses.
  void update(const BatchCounts& counts, double elapsed_seconds);

  /// Unset until this run has finished a clip.
  const std::optional<double>& seconds() const { return seconds_; }

 private:
  std::size_t done_ = 0;
  std::optional<double> seconds_;
};

}  // namespace mocapress
