// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal.h"

#include <unistd.h>
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

std::string printable(std::string_view text) {
  std::string line;
  const auto put_code = [&](char character) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(character));
    line += code;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte < 0x20 || byte == 0x7f) {
      put_code(text[i]);
    } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {  // U+0080 to U+009F in UTF-8
      put_code(text[++i]);
    } else {
      line += text[i];
    }
  }
  return line;
}

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

double ProgressLine::elapsed_seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool ProgressLine::due() const {
  return !quiet_ && elapsed_seconds() >= next_;
}

void ProgressLine::show(std::string line) {
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
