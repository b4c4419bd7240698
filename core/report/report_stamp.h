// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace mocapress {

/// The program that made a report, and the time.
struct ReportStamp {
  std::string program;  // "Mocapress 1.2.3"
  std::string time;     // ISO 8601, UTC
};

/// The stamp of this program at report_time().
ReportStamp report_stamp();

}  // namespace mocapress
