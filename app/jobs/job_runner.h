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

/// Who works through thousands tells of them this often at most.
inline constexpr auto kReportInterval = std::chrono::milliseconds(60);

/// What running work sees of the outside.
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

/// Runs jobs of one purpose, one at a time, on a thread of a pool, and delivers what they return or
/// throw on the thread it lives in. A newer job asks the running one to stop and makes it void:
/// nothing of a void job is delivered any more. Destruction asks for a stop and waits, so that no
/// job outlives what it uses.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  using Failed = std::function<void(const QString& message)>;

  explicit JobRunner(Workers workers = Workers::WaitedFor, QObject* parent = nullptr);
  ~JobRunner() override;

  /// `work(const Job&)` runs off this thread; then either `done(its result)` or `failed(message)`
  /// runs on it. Values in, values out: `work` must not touch what others can change.
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

  /// Asks the running job to end soon; its result is delivered.
  void stopEarly();

  /// Asks the running job to stop and makes it void.
  void abandon();

  /// Waits until the last job that was started has run: for what must not be lost, when the program
  /// ends.
  void finish();

  bool busy() const { return busy_; }

 signals:
  void busyChanged(bool busy);

  /// From the job's thread: posted_ has one more.
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

  /// What the threads of the pool see: one of them may look here after the runner is gone.
  struct Queue {
    std::mutex mutex;  // guards the rest
    std::condition_variable idle;
    std::optional<Waiting> waiting;
    bool looked_after = false;  // a thread of the pool will look for what waits, or does
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
  std::stop_source stop_;  // of the newest job
  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();

  // Qt's events only say that there is something here: a thread sanitizer does not see into Qt.
  std::mutex mutex_;  // guards posted_
  std::deque<std::pair<std::uint64_t, Delivery>> posted_;
};

}  // namespace mocapress
