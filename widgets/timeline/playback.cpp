// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mocapress {
namespace {

constexpr double kFastest = 8;  // highest speed of the shuttle

}  // namespace

Playback::Seconds Playback::steadyClock() {
  return [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
}

Playback::Playback(Seconds clock, QObject* parent) : QObject(parent), clock_(std::move(clock)) {
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(std::chrono::milliseconds(16));
  connect(&timer_, &QTimer::timeout, this, &Playback::tick);
}

void Playback::setClip(int frames, double sample_rate_hz) {
  pause();
  frames_ = frames;
  sample_rate_hz_ = sample_rate_hz;
  frame_ = 0;
  range_.reset();
  repeats_first_ = false;
  emit clipChanged();
  emit rangeChanged();
  emit frameChanged(frame_);
}

void Playback::setRange(const std::optional<std::pair<int, int>>& range) {
  range_.reset();
  if (range && frames_ > 1) {
    const int from = std::clamp(range->first, 0, frames_ - 2);
    range_.emplace(from, std::clamp(range->second, from + 1, frames_ - 1));
  }
  restartFrom(frame_);
  emit rangeChanged();
}

void Playback::play() {
  if (!playing()) startFrom(frame_ == last() ? first() : frame_, 1);
}

void Playback::shuttle(int direction) {
  const bool faster = playing() && pace_ * direction > 0;
  startFrom(frame_, faster ? std::clamp(2 * pace_, -kFastest, kFastest) : direction);
}

void Playback::startFrom(int frame, double pace) {
  if (frames_ < 2) return;
  pace_ = pace;
  show(std::clamp(frame, first(), last()));
  restartFrom(frame_);
  if (playing()) return;
  timer_.start();
  emit playingChanged(true);
}

void Playback::pause() {
  if (!playing()) return;
  timer_.stop();
  emit playingChanged(false);
}

void Playback::toggle() {
  playing() ? pause() : play();
}

void Playback::seek(int frame) {
  if (frames_ == 0) return;
  show(std::clamp(frame, 0, frames_ - 1));
  restartFrom(frame_);
}

void Playback::step(int frames) {
  pause();
  seek(frame_ + frames);
}

void Playback::setLoops(bool loops) {
  loops_ = loops;
}

void Playback::setRepeatsFirst(bool repeats) {
  repeats_first_ = repeats;
}

void Playback::setSpeed(double speed) {
  speed_ = speed;
  restartFrom(frame_);
}

void Playback::tick() {
  if (!playing()) return;
  const double passed = (clock_() - start_seconds_) * sample_rate_hz_ * speed_ * pace_;
  const auto frame = start_frame_ + static_cast<long long>(passed);
  if (loops_) {
    const long long length = last() - first() + (repeats_first_ && !range_ ? 0 : 1);
    const long long into = ((frame - first()) % length + length) % length;
    show(first() + static_cast<int>(into));
  } else if (frame >= first() && frame <= last()) {
    show(static_cast<int>(frame));
  } else {
    show(pace_ > 0 ? last() : first());
    pause();
  }
}

void Playback::show(int frame) {
  if (frame == frame_) return;
  frame_ = frame;
  emit frameChanged(frame);
}

void Playback::restartFrom(int frame) {
  start_frame_ = frame;
  start_seconds_ = clock_();
}

}  // namespace mocapress
