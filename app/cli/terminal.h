// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <string>

#include "core/base/printable.h"

namespace mocapress::cli {

/// Formats a duration: "0:42", "1:05:10".
std::string clock_text(double seconds);

/// Progress on standard error: one changing line on a terminal, else a line every few seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);

  double elapsed_seconds() const;

  /// True when the next report is due. Work that ends within 0.3 s reports nothing.
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

/// Asks long work to stop on a signal; a second signal ends the program.
class StopOnSignals {
 public:
  StopOnSignals();
};

}  // namespace mocapress::cli
