// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace mocapress::cli {

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
