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

namespace mocapress {

/// What may be asked of a running batch, from any thread.
class BatchControl {
 public:
  /// Workers stop where they are and wait.
  void pause();
  void resume();

  /// Clips that are being worked on are finished, no other is begun.
  void stop_after_current();

  /// Clips that are being worked on are dropped: they are waiting again.
  void cancel();

  bool paused() const;
  bool cancelled() const;

  /// Asked by workers before a clip and within one; both wait while paused.
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
  std::size_t clips = 0;  // of this shard
  std::size_t done = 0;   // ended, one way or the other
  std::size_t kept = 0;   // of those, done by an earlier run
  std::size_t failed = 0;
  std::uint64_t bytes = 0;  // of the clips' files, which time goes by
  std::uint64_t bytes_done = 0;
  std::uint64_t bytes_kept = 0;
  double bytes_under_way = 0;  // of clips that are being worked on, as far as they are
};

/// One step of one clip, or of the bank that is made of all.
struct BatchProgress {
  BatchCounts counts;
  std::optional<BankProgress> bank;  // then what follows says nothing
  std::size_t index = 0;             // of the clip in the batch
  ClipProgress clip;                 // while it is being worked on
  const BatchRow* row = nullptr;     // when it has ended
  bool kept = false;                 // by an earlier run
};

struct BatchRunOptions {
  Shard shard;
  int jobs = 0;  // clips at a time; 0: as many as processors
  bool overwrite = false;
  bool resumed = false;
  bool keep_going = true;                   // false: the first clip that fails ends it
  std::optional<double> clip_seconds = {};  // a clip that takes longer fails; unset: no limit
  bool take_over = false;  // the journal of a run on another computer that is no longer there
};

struct BatchOutcome {
  BatchCounts counts;
  bool complete = true;  // false: some clips are still waiting
  Warnings warnings;     // of the journal and the bank; those of clips are in their rows
  bool has_bank = false;
};

/// Does the clips of a shard into `folder`, each on one thread while there are others to do, the
/// largest first: as many clips are in memory as threads work. Each row is in the journal before
/// the next clip begins. The observer is called by one thread at a time; when it says no, or the
/// control is told to, clips that are not done are waiting again. Throws WriteError when the
/// journal cannot be written; all else is in the rows.
BatchOutcome run_batch(const Batch& batch, const std::filesystem::path& folder, Journal& journal,
                       const BatchRunOptions& options, BatchControl& control,
                       const Observer<BatchProgress>& observer = {});

/// How long a running batch still takes, by how fast it was so far. Until the next clip ends it
/// never grows: how far a clip is, is a guess, and a long one says nothing about the others.
class TimeLeft {
 public:
  /// With every news of the batch; `elapsed_seconds` without pauses.
  void update(const BatchCounts& counts, double elapsed_seconds);

  /// Unset until a clip was worked on to its end.
  const std::optional<double>& seconds() const { return seconds_; }

 private:
  std::size_t done_ = 0;
  std::optional<double> seconds_;
};

}  // namespace mocapress
