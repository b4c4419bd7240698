// SPDX-License-Identifier: MIT
// Rate-distortion curves, as in the paper's Figure 2 and Table 1.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace mocapress {

/// A compression ratio and its error.
struct CurvePoint {
  double ratio;
  double eps_cm;
};

/// Points in the order of their ratios. Errors rise with the ratios: no point has both a larger
/// ratio and a smaller error than another.
using Curve = std::vector<CurvePoint>;

/// Selects the points that no other point beats in both ratio and error. Leaves out points with
/// zero error, which have no place on a logarithmic axis.
Curve best_of(std::vector<CurvePoint> points);

/// Returns the ratio of a curve at an error. Between points, log(ratio) is linear in log(error).
/// Unset beyond the curve's ends: nothing is extrapolated.
std::optional<double> ratio_at(const Curve& curve, double eps_cm);

/// The geometric mean of positive values; unset for an empty list.
std::optional<double> geometric_mean(std::span<const double> values);

/// Returns the geometric mean of the curves' ratios at equal errors, for `points` errors in the
/// range that all curves cover. Empty if there is no such range.
Curve mean_at_equal_error(std::span<const Curve> curves, int points = 33);

}  // namespace mocapress
