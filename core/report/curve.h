// SPDX-License-Identifier: MIT
// Rate against distortion, as in the paper's Figure 2 and Table 1.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace mocapress {

/// A size and what it costs.
struct CurvePoint {
  double ratio;
  double eps_cm;
};

/// Settings of which none is both smaller and better than another: ratio and eps_x rise together.
using Curve = std::vector<CurvePoint>;

/// The best of the measured points. Points without an error, which have no place on a logarithmic
/// axis, are left out.
Curve best_of(std::vector<CurvePoint> points);

/// The ratio where a curve, straight between its points in the logarithms of both, has this error.
/// Unset beyond its ends: nothing is extrapolated.
std::optional<double> ratio_at(const Curve& curve, double eps_cm);

/// The geometric mean of positive values; unset when there are none.
std::optional<double> geometric_mean(std::span<const double> values);

/// The geometric mean over curves of the ratio at equal error, at so many errors over the range
/// that all of them cover. Empty when there is none.
Curve mean_at_equal_error(std::span<const Curve> curves, int points = 33);

}  // namespace mocapress
