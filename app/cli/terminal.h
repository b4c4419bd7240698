// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <string>

#include "core/base/printable.h"

namespace mocapress::cli {

/// "0:42", "1:05:10".
std::string clock_text(double seconds);

/// Progress on standard error: one line that changes on a terminal, else one every few seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);

  double elapsed_seconds() const;

  /// Whether the next one is due; what is done at once needs no progress.
  bool due() const;
  void show(std::string line);
  void clear() const;

 private:
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  double next_ = 0.3;  // s
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The signal that asked the program to stop; 0: none.
inline volatile std::sig_atomic_t stop_signal = 0;

/// Asks long work to stop when the user or the system does; a second signal ends the program.
class StopOnSignals {
 public:
  StopOnSignals() {
    struct sigaction action = {};
    action.sa_handler = [](int signal) { stop_signal = signal; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
  }
};

}  // namespace mocapress::cli
