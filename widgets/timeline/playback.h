// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <utility>

namespace mocapress {

/// Decides which frame is shown. During playback, the frame follows from the clock and the clip's
/// sample rate: late timer ticks skip frames but never slow the motion.
class Playback : public QObject {
  Q_OBJECT

 public:
  using Seconds = std::function<double()>;  // a monotonic clock

  static Seconds steadyClock();

  explicit Playback(Seconds clock = steadyClock(), QObject* parent = nullptr);

  /// Stops at the first frame. A clip without frames cannot play.
  void setClip(int frames, double sample_rate_hz);

  int frame() const { return frame_; }
  int frames() const { return frames_; }
  double sampleRate() const { return sample_rate_hz_; }  // Hz
  bool playing() const { return timer_.isActive(); }
  bool loops() const { return loops_; }

  /// The part of the clip that is played; unset: the whole clip. A new clip resets it.
  const std::optional<std::pair<int, int>>& range() const { return range_; }
  void setRange(const std::optional<std::pair<int, int>>& range);

  /// Plays; starts again from the beginning if the end was reached.
  void play();

  /// Plays forwards (1) or backwards (-1), like the keys L and J of video editors. Each repetition
  /// doubles the speed.
  void shuttle(int direction);
  void pause();
  void toggle();

  /// Goes to a frame, clamped to the clip. Playback continues from there.
  void seek(int frame);

  /// Pauses and moves by `frames`.
  void step(int frames);

  void setLoops(bool loops);

  /// Tells that the last frame repeats the pose of the first. A loop of the whole clip then skips
  /// the last frame, where the figure would otherwise halt for a frame. A new clip resets this.
  void setRepeatsFirst(bool repeats);

  /// Sets the speed; 1: as recorded.
  void setSpeed(double speed);

  /// Shows the frame that is due by the clock; called by a timer during playback.
  void tick();

 signals:
  void frameChanged(int frame);
  void playingChanged(bool playing);
  void clipChanged();
  void rangeChanged();

 private:
  void startFrom(int frame, double pace);
  int first() const { return range_ ? range_->first : 0; }
  int last() const { return range_ ? range_->second : frames_ - 1; }
  void show(int frame);
  void restartFrom(int frame);

  Seconds clock_;
  QTimer timer_;
  int frames_ = 0;
  double sample_rate_hz_ = 120;
  int frame_ = 0;
  double speed_ = 1;
  double pace_ = 1;  // speed factor of the shuttle; negative: backwards
  std::optional<std::pair<int, int>> range_;
  bool loops_ = true;
  bool repeats_first_ = false;
  int start_frame_ = 0;  // frame at the time start_seconds_
  double start_seconds_ = 0;
};

}  // namespace mocapress
