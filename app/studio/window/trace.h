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

/// Measures what the user waits for, and writes it to standard error where asked to.
class Trace : public QObject {
  Q_OBJECT

 public:
  Trace(Session* session, Viewport* viewport, QObject* parent = nullptr);

  /// While it writes it also watches how long the GUI thread is away from its events.
  void setWriting(bool writing);

  /// The longest time away and the most work at a time since then or since the last call, ms.
  struct Block {
    double away;
    double worked;
  };
  Block takeLongestBlock();

 signals:
  /// From the first slider movement without a picture to the picture of an answer to it.
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
  double longest_block_ = 0;  // ms
  double longest_work_ = 0;
  double worked_ = 0;  // by the GUI thread at the last beat
};

}  // namespace mocapress
