// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <optional>

class QString;

namespace mocapress {

class Session;
class Viewport;

/// Measures waiting times of the user and writes them to standard error on request.
class Trace : public QObject {
  Q_OBJECT

 public:
  Trace(Session* session, Viewport* viewport, QObject* parent = nullptr);

  /// While writing is on, Trace also measures how long the GUI thread is blocked.
  void setWriting(bool writing);

  /// The longest pause of the GUI thread and its longest work without a pause, in ms, since writing
  /// began or since the last call.
  struct Block {
    double away;
    double worked;
  };
  Block takeLongestBlock();

 signals:
  /// Time from a slider's movement to the picture of its answer. Counts from the first movement
  /// since the last such picture.
  void sliderToPicture(double milliseconds);

 private:
  using Clock = std::chrono::steady_clock;

  void moved();
  void answered();
  void drawn();
  void beat();
  void write(const char* what, double milliseconds) const;

  Session* session_;
  bool writing_ = false;
  std::optional<Clock::time_point> moved_;
  bool answered_ = false;
  QTimer heart_;
  Clock::time_point last_beat_;
  double longest_block_ = 0;  // in ms
  double longest_work_ = 0;
  double worked_ = 0;  // processor time of the GUI thread at the last beat
};

}  // namespace mocapress
