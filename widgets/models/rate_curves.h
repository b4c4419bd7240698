// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/study/results.h"

namespace mocapress {

/// A measured row in a rate-distortion plot.
struct RatePoint {
  double ratio;
  double eps_cm;
  int row;  // among the rows of the study
};

/// A series in a rate-distortion plot.
struct RateCurve {
  Series series;
  Curve line;
  std::vector<RatePoint> points;
  bool mean = false;  // the line is that of many clips, and the points are not on it
};

/// One curve a series, in the order of compression_methods(): of the clip with this path, or, where
/// it is empty, the mean (Results::mean_curve()) over those of `complete` with the points of all
/// clips.
std::vector<RateCurve> rateCurves(const std::vector<StudyRow>& rows, const std::string& clip,
                                  const std::set<std::string>& complete);

}  // namespace mocapress
