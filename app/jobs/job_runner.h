// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "app/jobs/worker_pool.h"

namespace mocapress {

class JobRunner;

/// The shortest interval between reports of a job that handles thousands of items.
inline constexpr auto kReportInterval = std::chrono::milliseconds(60);

/// A running job's link to its runner.
class Job {
 public:
  bool stopRequested() const { return stop_.stop_requested(); }

  /// Runs `report` on the runner's thread, unless the job is void by then.
  void post(std::function<void()> report) const;

 private:
  friend class JobRunner;
  JobRunner* runner_ = nullptr;
  std::uint64_t id_ = 0;
  std::stop_token stop_;
};

/// Runs jobs of one purpose, one at a time, on a thread of a pool, and delivers results and errors
/// on the runner's own thread. A newer job asks the running one to stop and makes it void: a void
/// job delivers nothing. The destructor asks for a stop and waits, so that no job outlives the data
/// it uses.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  using Failed = std::function<void(const QString& message)>;

  explicit JobRunner(Workers workers = Workers::WaitedFor, QObject* parent = nullptr);
  ~JobRunner() override;

  /// Runs `work(const Job&)` on another thread, then `done(result)` or `failed(message)` on the
  /// runner's thread. `work` must own its data or share only constant data.
  template <typename Work, typename Done>
  void start(Work work, Done done, Failed failed) {
    using Result = std::invoke_result_t<Work, const Job&>;
    launch(
        [work = std::move(work), done = std::move(done)](const Job& job) -> Delivery {
          auto result = std::make_shared<Result>(work(job));
          return [result, done] { done(std::move(*result)); };
        },
        std::move(failed));
  }

  /// Asks the running job to end soon, and still delivers its result.
  void stopEarly();

  /// Asks the running job to stop and makes it void.
  void abandon();

  /// Waits until the last started job has run, for work that must not be lost at the end of the
  /// program.
  void finish();

  bool busy() const { return busy_; }

 signals:
  void busyChanged(bool busy);

  /// Emitted from the job's thread: posted_ has a new entry.
  void posted(QPrivateSignal);

 private:
  friend class Job;
  using Delivery = std::function<void()>;
  using Work = std::function<Delivery(const Job&)>;
  struct Waiting {
    Job job;
    Work work;
    Failed failed;
  };

  /// State shared with the pool, whose threads may use it after the runner is gone.
  struct Queue {
    std::mutex mutex;  // guards the members below
    std::condition_variable idle;
    std::optional<Waiting> waiting;
    bool looked_after = false;  // a pool thread handles the queue or is about to
    bool running = false;
  };

  void launch(Work work, Failed failed);
  static void lookAfter(const std::shared_ptr<Queue>& queue);
  static void run(const Waiting& next);
  void post(std::uint64_t id, Delivery delivery);
  void deliverNext();
  void setBusy(bool busy);

  Workers workers_;
  std::uint64_t current_id_ = 0;  // jobs with another id are void
  bool busy_ = false;
  std::stop_source stop_;  // stops the newest job
  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();

  // Qt's events only signal that posted_ has entries: a thread sanitizer cannot follow data through
  // Qt.
  std::mutex mutex_;  // guards posted_
  std::deque<std::pair<std::uint64_t, Delivery>> posted_;
};

}  // namespace mocapress
