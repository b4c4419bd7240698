// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/metrics/visibility.h"

namespace mocapress {

/// What is seen over time, of one joint or of the worst at each moment.
struct SightLine {
  std::string joint;   // empty: the worst of all
  std::string sights;  // a digit a column: 0 not visible, 1 borderline, 2 visible

  bool operator==(const SightLine&) const = default;
};

/// What is seen by joint and time, small enough to be kept for each clip of a batch: the worst of
/// all first, then the joints that are seen most, those that are not left out.
using SightChart = std::vector<SightLine>;

SightChart sight_chart(const SightTable& table, const Skeleton& skeleton);

/// What its colours and heights mean.
inline constexpr const char* kSightLegend =
    "Over time, any joint and those seen most: nothing where an error is not visible, half a bar "
    "where it is borderline, a whole one where it is visible.";

/// An inline <svg>, coloured by the classes of report_style.h. `label` for those who cannot see it.
std::string draw(const SightChart& chart, double seconds, const std::string& label);

}  // namespace mocapress
