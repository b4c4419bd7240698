// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/visibility.h"
#include "core/report/report_language.h"

namespace mocapress {

/// Visibility over time, of one joint or of the worst at each moment.
struct SightLine {
  std::string joint;   // empty: the worst of all joints
  std::string sights;  // one digit for each column: 0 not visible, 1 borderline, 2 visible

  bool operator==(const SightLine&) const = default;
};

/// Visibility by joint and time, small enough to be kept for each clip of a batch: first the worst
/// of all joints, then the most visible joints.
using SightChart = std::vector<SightLine>;

SightChart sight_chart(const SightTable& table, const Skeleton& skeleton);

/// Legend for its colours and heights.
inline constexpr const char* kSightLegend =
    "Rows are joints, the first row is any joint. A full bar marks times with visible errors, half "
    "a bar borderline ones, no bar errors that nobody sees.";

/// Returns an inline <svg>, coloured by the classes of report_style.h. `label` is for screen
/// readers.
std::string draw(const SightChart& chart, double seconds, const std::string& label,
                 const ReportLanguage& say = {});

}  // namespace mocapress
