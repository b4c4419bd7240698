// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/worker_pool.h"

#include <QtGlobal>
#include <utility>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace mocapress {
namespace {

constexpr std::size_t kMostThreads = 8;  // the studio runs at most this many jobs of a kind

/// Lowers the priority of the calling thread.
void lowerPriority([[maybe_unused]] LowerPriority how) {
#ifdef Q_OS_LINUX
  // Linux has a niceness for each thread, and a new thread inherits it.
  constexpr int kNice = 10;
  constexpr int kNicest = 19;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()),
              how == LowerPriority::ToTheWindow ? kNice : kNicest);
#endif
}

}  // namespace

WorkerPool& WorkerPool::of(Workers workers) {
  static WorkerPool waited_for(kMostThreads, LowerPriority::ToTheWindow);
  static WorkerPool long_running(kMostThreads, LowerPriority::ToTheWindow);
  static WorkerPool idle(1, LowerPriority::ToEverything);
  switch (workers) {
    case Workers::WaitedFor:
      return waited_for;
    case Workers::LongRunning:
      return long_running;
    case Workers::Idle:
      break;
  }
  return idle;
}

WorkerPool::WorkerPool(std::size_t most_threads, LowerPriority priority)
    : most_threads_(most_threads), priority_(priority) {}

WorkerPool::~WorkerPool() {
  for (std::jthread& thread : threads_) thread.request_stop();
  threads_.clear();
}

void WorkerPool::run(std::function<void()> work) {
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(work));
    if (free_threads_ < waiting_.size() && threads_.size() < most_threads_)
      threads_.emplace_back([this](const std::stop_token& quit) { serve(quit); });
  }
  wake_.notify_one();
}

void WorkerPool::serve(const std::stop_token& quit) {
  lowerPriority(priority_);
  std::unique_lock lock(mutex_);
  while (true) {
    ++free_threads_;
    const bool found = wake_.wait(lock, quit, [this] { return !waiting_.empty(); });
    --free_threads_;
    if (!found || quit.stop_requested()) return;
    std::function<void()> work = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    work();
    work = nullptr;
    lock.lock();
  }
}

}  // namespace mocapress
