// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
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

  void setWriting(bool writing) { writing_ = writing; }

 signals:
  /// From the first slider movement without a picture to the picture of an answer to it.
  void sliderToPicture(double milliseconds);

 private:
  using Clock = std::chrono::steady_clock;

  void moved();
  void answered();
  void drawn();
  void write(const char* what, double milliseconds) const;

  Session* session_;
  bool writing_ = false;
  std::optional<Clock::time_point> moved_;
  bool answered_ = false;
};

}  // namespace mocapress
