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

  /// Lets workers finish their clips without beginning others.
  void stop_after_current();

  /// Makes workers drop their clips, which wait again.
  void cancel();

  bool paused() const;
  bool cancelled() const;

  /// Called by workers before a clip and during one; both wait while paused.
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
  std::size_t done = 0;   // ended, done or failed
  std::size_t kept = 0;   // those among `done` that an earlier run did
  std::size_t failed = 0;
  std::uint64_t bytes = 0;  // size of the clips' files, by which time is estimated
  std::uint64_t bytes_done = 0;
  std::uint64_t bytes_kept = 0;
  double bytes_under_way = 0;  // share done of the clips being worked on, in bytes
};

/// A step of one clip, or of the bank made of all clips.
struct BatchProgress {
  BatchCounts counts;
  std::optional<BankProgress> bank;  // if set, the members below are unused
  std::size_t index = 0;             // clip's index in the batch
  ClipProgress clip;                 // valid while the clip is worked on
  const BatchRow* row = nullptr;     // set when the clip has ended
  bool kept = false;                 // true: an earlier run did it
};

struct BatchRunOptions {
  Shard shard;
  int jobs = 0;  // clips at a time; 0: one for each processor
  bool overwrite = false;
  bool resumed = false;
  bool keep_going = true;                   // false: the first failure ends the run
  std::optional<double> clip_seconds = {};  // time limit for a clip; unset: none
  bool largest_first = true;                // false: in the order of the batch
  bool take_over = false;  // true: takes the journal of a run on another computer that has ended
  ReportLanguage language = {};  // the page's language
};

struct BatchOutcome {
  BatchCounts counts;
  bool complete = true;  // false: some clips still wait
  Warnings warnings;     // about the journal and the bank; a clip's are in its row
  bool has_bank = false;
};

/// Does the clips of a shard into `folder`. Each takes one thread while others
/// wait, so memory holds as many clips as threads work. Each row is in the journal before the
/// worker's next clip begins. The observer is called by one thread at a time. If it refuses, or the
/// control says so, clips that are not done wait again. Throws WriteError if the journal cannot be
/// written; all other failures are in the rows.
BatchOutcome run_batch(const Batch& batch, const std::filesystem::path& folder, Journal& journal,
                       const BatchRunOptions& options, BatchControl& control,
                       const Observer<BatchProgress>& observer = {});

/// An estimate of the time that a running batch still takes, from its speed so far. It never grows
/// until the next clip ends, since progress within a clip is a guess and a long clip says nothing
/// about the others.
class TimeLeft {
 public:
  /// Call at every step of the batch; `elapsed_seconds` without pauses.
  void update(const BatchCounts& counts, double elapsed_seconds);

  /// Unset until a clip has ended.
  const std::optional<double>& seconds() const { return seconds_; }

 private:
  std::size_t done_ = 0;
  std::optional<double> seconds_;
};

}  // namespace mocapress
