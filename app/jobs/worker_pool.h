// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace mocapress {

/// How much the threads of a pool, and those that they start, give way to others: the window comes
/// before all work, and work that is waited for before what is not. No effect but on Linux.
enum class LowerPriority { ToTheWindow, ToEverything };

/// What a job is for, which decides what threads it is done by.
enum class Workers {
  WaitedFor,    // the answer to a slider, a file to open or to save
  LongRunning,  // a batch, a study, the reading of a library: for hours, and it may be paused
  Idle          // what nobody waits for: it gives way to everything
};

/// Threads that jobs share. They are started when they are needed, and stay.
///
/// There is a pool for each kind of work, so that a slider never waits behind a batch. Each has
/// threads for as many jobs as there can be at a time, so that no job waits because another is
/// paused: the pools bound threads, not work, which the parallel loops of core share anyway. Made
/// of the standard library's parts, unlike QThreadPool, for the thread sanitizer to follow.
class WorkerPool {
 public:
  static WorkerPool& of(Workers workers);

  WorkerPool(std::size_t most_threads, LowerPriority priority);

  /// Waits for what has begun. What has not is dropped.
  ~WorkerPool();

  void run(std::function<void()> work);

 private:
  void serve(const std::stop_token& quit);

  std::size_t most_threads_;
  LowerPriority priority_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable_any wake_;
  std::deque<std::function<void()>> waiting_;
  std::size_t free_threads_ = 0;  // that wait for work
  std::vector<std::jthread> threads_;
};

}  // namespace mocapress
