// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"

#include <exception>
#include <utility>

namespace mocapress {

void Job::post(std::function<void()> report) const {
  runner_->post(id_, std::move(report));
}

JobRunner::JobRunner(Workers workers, QObject* parent) : QObject(parent), workers_(workers) {
  connect(this, &JobRunner::posted, this, &JobRunner::deliverNext, Qt::QueuedConnection);
}

JobRunner::~JobRunner() {
  stop_.request_stop();
  std::unique_lock lock(queue_->mutex);
  queue_->waiting.reset();
  queue_->idle.wait(lock, [this] { return !queue_->running; });
}

void JobRunner::stopEarly() {
  stop_.request_stop();
}

void JobRunner::abandon() {
  stop_.request_stop();
  ++current_id_;
  {
    const std::scoped_lock lock(queue_->mutex);
    queue_->waiting.reset();
  }
  setBusy(false);
}

void JobRunner::finish() {
  std::unique_lock lock(queue_->mutex);
  queue_->idle.wait(lock, [this] { return !queue_->waiting && !queue_->running; });
}

void JobRunner::launch(Work work, Failed failed) {
  stop_.request_stop();
  stop_ = std::stop_source();
  Job job;
  job.runner_ = this;
  job.id_ = ++current_id_;
  job.stop_ = stop_.get_token();
  bool looked_after = false;
  {
    const std::scoped_lock lock(queue_->mutex);
    queue_->waiting = Waiting{job, std::move(work), std::move(failed)};
    looked_after = std::exchange(queue_->looked_after, true);
  }
  if (!looked_after) WorkerPool::of(workers_).run([queue = queue_] { lookAfter(queue); });
  setBusy(true);
}

/// Runs waiting jobs until none is left; called on a thread of the pool.
void JobRunner::lookAfter(const std::shared_ptr<Queue>& queue) {
  std::unique_lock lock(queue->mutex);
  while (queue->waiting) {
    std::optional<Waiting> next = std::move(queue->waiting);
    queue->waiting.reset();
    queue->running = true;
    lock.unlock();
    run(*next);
    next.reset();  // frees what the job holds
    lock.lock();
    queue->running = false;
    queue->idle.notify_all();
  }
  queue->looked_after = false;
}

void JobRunner::run(const Waiting& next) {
  Delivery delivery;
  const auto failure = [&next](const QString& message) {
    return [failed = next.failed, message] { failed(message); };
  };
  try {
    delivery = next.work(next.job);
  } catch (const std::exception& error) {
    delivery = failure(QString::fromStdString(error.what()));
  } catch (...) {
    delivery = failure(tr("An unknown error occurred."));
  }
  next.job.post([runner = next.job.runner_, delivery = std::move(delivery)] {
    runner->setBusy(false);
    delivery();
  });
}

void JobRunner::post(std::uint64_t id, Delivery delivery) {
  {
    const std::scoped_lock lock(mutex_);
    posted_.emplace_back(id, std::move(delivery));
  }
  emit posted(QPrivateSignal());
}

void JobRunner::deliverNext() {
  std::unique_lock lock(mutex_);
  const auto [id, delivery] = std::move(posted_.front());
  posted_.pop_front();
  lock.unlock();
  if (id == current_id_) delivery();
}

void JobRunner::setBusy(bool busy) {
  if (busy == busy_) return;
  busy_ = busy;
  emit busyChanged(busy);
}

}  // namespace mocapress
