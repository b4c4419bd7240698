// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <cstdio>

namespace mocapress::cli {

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(seconds);
  char text[32];
  if (whole < 3600)
    std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

namespace {

bool is_terminal(std::FILE* stream) {
#ifdef _WIN32
  return _isatty(_fileno(stream)) != 0;
#else
  return isatty(fileno(stream)) != 0;
#endif
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(is_terminal(stderr)) {}

StopOnSignals::StopOnSignals() {
  const auto ask_to_stop = [](int signal) { stop_signal = signal; };
#ifdef _WIN32
  // Windows resets a handler after its first call. SIGBREAK stands for Ctrl+Break, a closed window
  // and the end of the session.
  for (const int signal : {SIGINT, SIGTERM, SIGBREAK}) std::signal(signal, ask_to_stop);
#else
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
#endif
}

double ProgressLine::elapsed_seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool ProgressLine::due() const {
  return !quiet_ && elapsed_seconds() >= next_;
}

void ProgressLine::show(std::string line) {
  line = printable(line);
  next_ = elapsed_seconds() + (terminal_ ? 0.1 : 5.0);
  if (!terminal_) {
    std::fprintf(stderr, "%s\n", line.c_str());
    return;
  }
  constexpr std::size_t kWidth = 78;
  line.resize(kWidth, ' ');
  std::fprintf(stderr, "\r%s", line.c_str());
  shown_ = true;
}

void ProgressLine::clear() const {
  if (shown_) std::fprintf(stderr, "\r%78s\r", "");
}

}  // namespace mocapress::cli
