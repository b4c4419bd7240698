// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mocapress {

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
  emit clipChanged();
  emit frameChanged(frame_);
}

void Playback::play() {
  if (playing() || frames_ < 2) return;
  if (frame_ == frames_ - 1) show(0);
  restartFrom(frame_);
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

void Playback::setSpeed(double speed) {
  speed_ = speed;
  restartFrom(frame_);
}

void Playback::tick() {
  if (!playing()) return;
  const double passed = (clock_() - start_seconds_) * sample_rate_hz_ * speed_;
  const auto frame = start_frame_ + static_cast<long long>(std::floor(passed));
  if (frame < frames_ || loops_) {
    show(static_cast<int>(frame % frames_));
  } else {
    show(frames_ - 1);
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
