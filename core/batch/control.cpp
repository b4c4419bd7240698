// SPDX-License-Identifier: MIT
#include "core/batch/control.h"

#include <algorithm>

namespace mocapress {

void BatchControl::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
}

void BatchControl::should_continue() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  changed_.notify_all();
}

void BatchControl::stop_after_current() {
  wish(Wish::StopAfterCurrent);
}

void BatchControl::cancel() {
  wish(Wish::Cancel);
}

void BatchControl::wish(Wish wish) {
  const std::lock_guard lock(mutex_);
  wish_ = std::max(wish_, wish);
  paused_ = false;  // to stop, one must go on
  changed_.notify_all();
}

bool BatchControl::paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

bool BatchControl::cancelled() const {
  const std::lock_guard lock(mutex_);
  return wish_ == Wish::Cancel;
}

bool BatchControl::may_begin() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !paused_; });
  return wish_ == Wish::GoOn;
}

bool BatchControl::may_continue() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !paused_; });
  return wish_ != Wish::Cancel;
}

}  // namespace mocapress
