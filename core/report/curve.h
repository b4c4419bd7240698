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

/// Points of which none is both smaller and better than another: ratio and eps_x rise together.
using Curve = std::vector<CurvePoint>;

/// The best of the measured points. Points with zero error are left out: they have no place on a
/// logarithmic axis.
Curve best_of(std::vector<CurvePoint> points);

/// The ratio at which a curve, linear between its points in the logarithms of both, has this error.
/// Unset beyond its ends: nothing is extrapolated.
std::optional<double> ratio_at(const Curve& curve, double eps_cm);

/// The geometric mean of positive values; unset for an empty list.
std::optional<double> geometric_mean(std::span<const double> values);

/// The geometric mean over curves of the ratio at equal error, at `points` errors in the range that
/// all of them cover. Empty if there is no such range.
Curve mean_at_equal_error(std::span<const Curve> curves, int points = 33);

}  // namespace mocapress
