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

/// Priority of a pool's threads and of those that they start: below the window's, or below all
/// other work. Works on Linux only.
enum class LowerPriority { ToTheWindow, ToEverything };

/// Kinds of jobs, each with its own threads.
enum class Workers {
  WaitedFor,    // answers to sliders, opening and saving files
  LongRunning,  // batches, studies and reading a library: they run for hours and may be paused
  Idle          // work that nobody waits for, at the lowest priority
};

/// Threads that jobs share. They start on demand and stay.
///
/// Each kind of work has its own pool, so that a slider never waits behind a batch. Except for idle
/// work, a pool has a thread for every job that can exist at once, so that no job waits for a
/// paused one: pools limit threads, and core's parallel loops share the processors anyway. Standard
/// threads are used instead of QThreadPool because the thread sanitizer can follow them.
class WorkerPool {
 public:
  static WorkerPool& of(Workers workers);

  WorkerPool(std::size_t most_threads, LowerPriority priority);

  /// Waits for jobs that have begun and drops the others.
  ~WorkerPool();

  void run(std::function<void()> work);

 private:
  void serve(const std::stop_token& quit);

  std::size_t most_threads_;
  LowerPriority priority_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable_any wake_;
  std::deque<std::function<void()>> waiting_;
  std::size_t free_threads_ = 0;  // number of idle threads
  std::vector<std::jthread> threads_;
};

}  // namespace mocapress
