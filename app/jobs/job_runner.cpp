// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"

#include <exception>

#include "app/jobs/lower_priority.h"

namespace mocapress {

void Job::post(std::function<void()> report) const {
  runner_->post(id_, std::move(report));
}

JobRunner::JobRunner(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& quit) { serve(quit); }) {
  connect(this, &JobRunner::posted, this, &JobRunner::deliverNext, Qt::QueuedConnection);
}

JobRunner::~JobRunner() {
  stop_.request_stop();
  const std::scoped_lock lock(mutex_);
  waiting_.reset();
}

void JobRunner::stopEarly() {
  stop_.request_stop();
}

void JobRunner::abandon() {
  stop_.request_stop();
  ++current_id_;
  {
    const std::scoped_lock lock(mutex_);
    waiting_.reset();
  }
  setBusy(false);
}

void JobRunner::finish() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return !waiting_ && !running_; });
}

void JobRunner::launch(Work work, Failed failed) {
  stop_.request_stop();
  stop_ = std::stop_source();
  Job job;
  job.runner_ = this;
  job.id_ = ++current_id_;
  job.stop_ = stop_.get_token();
  {
    const std::scoped_lock lock(mutex_);
    waiting_ = Waiting{job, std::move(work), std::move(failed)};
  }
  wake_.notify_one();
  setBusy(true);
}

void JobRunner::serve(const std::stop_token& quit) {
  lowerPriority(LowerPriority::ToTheWindow);
  while (true) {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, quit, [this] { return waiting_.has_value(); })) return;
    const Waiting next = std::move(*waiting_);
    waiting_.reset();
    running_ = true;
    lock.unlock();

    Delivery delivery;
    const auto failure = [&next](const QString& message) {
      return [failed = next.failed, message] { failed(message); };
    };
    try {
      delivery = next.work(next.job);
    } catch (const std::exception& error) {
      delivery = failure(QString::fromStdString(error.what()));
    } catch (...) {
      delivery = failure(tr("Something unknown went wrong."));
    }
    next.job.post([this, delivery = std::move(delivery)] {
      setBusy(false);
      delivery();
    });
    lock.lock();
    running_ = false;
    idle_.notify_all();
  }
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
