// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/study/results.h"

namespace mocapress {

/// A measured row as a point of a rate-distortion plot.
struct RatePoint {
  double ratio;
  double eps_cm;
  int row;  // index among the rows of the study
};

/// A series in a rate-distortion plot.
struct RateCurve {
  Series series;
  Curve line;
  std::vector<RatePoint> points;
  bool mean = false;  // the line is the mean of many clips, and the points lie beside it
};

/// Makes one curve for each series, in the order of compression_methods(). A path selects one clip.
/// An empty path selects the mean over the clips of `complete` (Results::mean_curve()), with the
/// points of all clips.
std::vector<RateCurve> rateCurves(const std::vector<StudyRow>& rows, const std::string& clip,
                                  const std::set<std::string>& complete);

}  // namespace mocapress
