// SPDX-License-Identifier: MIT
#include "core/base/utc_time.h"

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace mocapress {

std::string utc_text(std::time_t time) {
  std::tm parts{};
  char text[32] = {};
#ifdef _WIN32
  const bool is_known = ::gmtime_s(&parts, &time) == 0;
#else
  const bool is_known = ::gmtime_r(&time, &parts) != nullptr;
#endif
  if (!is_known) return text;  // the year does not fit into an int
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::time_t report_time() {
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    std::time_t seconds = 0;
    const char* const end = fixed + std::strlen(fixed);
    const auto read = std::from_chars(fixed, end, seconds);
    if (read.ec == std::errc() && read.ptr == end) return seconds;
  }
  return std::time(nullptr);
}

}  // namespace mocapress
