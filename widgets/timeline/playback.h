// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

namespace mocapress {

/// Which frame is shown now. While it plays, the frame follows from the clock and the clip's rate;
/// late timer ticks drop frames and never slow the motion.
class Playback : public QObject {
  Q_OBJECT

 public:
  using Seconds = std::function<double()>;  // of a clock that only moves forward

  static Seconds steadyClock();

  explicit Playback(Seconds clock = steadyClock(), QObject* parent = nullptr);

  /// Stops at the first frame. No frames: nothing plays.
  void setClip(int frames, double sample_rate_hz);

  int frame() const { return frame_; }
  int frames() const { return frames_; }
  double sampleRate() const { return sample_rate_hz_; }  // Hz
  bool playing() const { return timer_.isActive(); }
  bool loops() const { return loops_; }

  /// From the start again when it stands at the end.
  void play();
  void pause();
  void toggle();

  /// Clamped to the clip; goes on playing from there.
  void seek(int frame);

  /// Pauses, and moves by that many frames.
  void step(int frames);

  void setLoops(bool loops);

  /// 1: as recorded.
  void setSpeed(double speed);

  /// Takes the frame from the clock; called by a timer while playing.
  void tick();

 signals:
  void frameChanged(int frame);
  void playingChanged(bool playing);
  void clipChanged();

 private:
  void show(int frame);
  void restartFrom(int frame);

  Seconds clock_;
  QTimer timer_;
  int frames_ = 0;
  double sample_rate_hz_ = 120;
  int frame_ = 0;
  double speed_ = 1;
  bool loops_ = true;
  int start_frame_ = 0;  // where the clock read start_seconds_
  double start_seconds_ = 0;
};

}  // namespace mocapress
