// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/visibility.h"
#include "core/report/report_language.h"

namespace mocapress {

/// Visibility over time, of one joint or of whichever joint is worst at a moment.
struct SightLine {
  std::string joint;   // name of the joint; empty: the worst of all joints
  std::string sights;  // a digit for each column: 0 not visible, 1 borderline, 2 visible

  bool operator==(const SightLine&) const = default;
};

/// Visibility by joint and time, small enough to store for each clip of a batch. The first line is
/// the worst of all joints; the most visible joints follow.
using SightChart = std::vector<SightLine>;

SightChart sight_chart(const SightTable& table, const Skeleton& skeleton);

/// Explains the chart's colours and heights.
inline constexpr const char* kSightLegend =
    "Rows are joints, the first row is any joint. A full bar marks times with visible errors, half "
    "a bar borderline ones, no bar errors that nobody sees.";

/// Draws a chart as an inline <svg>. The classes of report_style.h give the colours. `label` is for
/// screen readers.
std::string draw(const SightChart& chart, double seconds, const std::string& label,
                 const ReportLanguage& say = {});

}  // namespace mocapress
