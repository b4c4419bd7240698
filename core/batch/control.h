// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <mutex>

namespace mocapress {

/// What may be asked of a running batch, from any thread.
class BatchControl {
 public:
  /// Workers stop where they are and wait.
  void pause();
  void should_continue();

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

}  // namespace mocapress
