// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>
#include <string>

namespace mocapress {

/// Formats a time by ISO 8601: "2026-11-26T14:05:00Z".
std::string utc_text(std::time_t time);

/// The time for reports: now, or SOURCE_DATE_EPOCH if the environment sets it, so that the same run
/// can give the same bytes (reproducible-builds.org).
std::time_t report_time();

}  // namespace mocapress
