// SPDX-License-Identifier: MIT
// Phrases about visibility that several reports share, in the language of the report.
#pragma once

#include <string>

#include "core/metrics/visibility.h"
#include "core/report/report_language.h"

namespace mocapress {

/// "not visible".
std::string sight_phrase(const ReportLanguage& say, Sight sight);

/// Describes visibility: "not visible from 8 m".
std::string sight_phrase(const ReportLanguage& say, Sight sight, double distance_m);

}  // namespace mocapress
