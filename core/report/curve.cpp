// SPDX-License-Identifier: MIT
#include "core/report/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mocapress {

Curve best_of(std::vector<CurvePoint> points) {
  std::erase_if(points, [](const CurvePoint& p) { return !(p.eps_cm > 0 && p.ratio > 0); });
  std::ranges::sort(points, [](const CurvePoint& a, const CurvePoint& b) {
    return a.ratio != b.ratio ? a.ratio > b.ratio : a.eps_cm < b.eps_cm;
  });
  Curve curve;  // begins with the smallest file: each further point must have a smaller error
  for (const CurvePoint& point : points)
    if (curve.empty() || point.eps_cm < curve.back().eps_cm) curve.push_back(point);
  std::ranges::reverse(curve);
  return curve;
}

std::optional<double> ratio_at(const Curve& curve, double eps_cm) {
  if (curve.empty() || eps_cm < curve.front().eps_cm || eps_cm > curve.back().eps_cm)
    return std::nullopt;
  const auto above = std::ranges::find_if(curve, [&](auto& p) { return p.eps_cm >= eps_cm; });
  if (above == curve.begin()) return above->ratio;
  const auto below = above - 1;
  const double share = std::log(eps_cm / below->eps_cm) / std::log(above->eps_cm / below->eps_cm);
  return below->ratio * std::pow(above->ratio / below->ratio, share);
}

std::optional<double> geometric_mean(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  double sum_of_logs = 0;
  for (const double value : values) sum_of_logs += std::log(value);
  return std::exp(sum_of_logs / static_cast<double>(values.size()));
}

Curve mean_at_equal_error(std::span<const Curve> curves, int points) {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves) {
    if (curve.empty()) return {};
    low = std::max(low, curve.front().eps_cm);
    high = std::min(high, curve.back().eps_cm);
  }
  if (curves.empty() || low >= high) return {};
  Curve mean;
  for (int i = 0; i < points; ++i) {
    // The last point is not computed, since rounding could put it beyond the curve's end.
    const double eps_cm = i + 1 == points ? high : low * std::pow(high / low, i / (points - 1.0));
    std::vector<double> ratios;
    for (const Curve& curve : curves)
      if (const auto ratio = ratio_at(curve, eps_cm)) ratios.push_back(*ratio);
    if (ratios.size() == curves.size()) mean.push_back({*geometric_mean(ratios), eps_cm});
  }
  return mean;
}

}  // namespace mocapress
