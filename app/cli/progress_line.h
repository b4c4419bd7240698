// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

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

}  // namespace mocapress::cli
