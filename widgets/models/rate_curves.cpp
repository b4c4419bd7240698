// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/rate_curves.h"

#include <algorithm>
#include <tuple>

#include "core/codec/methods/compression_method.h"

namespace mocapress {
namespace {

std::vector<Series> inOrder(std::vector<Series> series) {
  const auto place = [](const Series& s) {
    return std::tuple(find_compression_method(s.method), s.ik_ratio.value_or(0));
  };
  std::sort(series.begin(), series.end(),
            [&](const Series& a, const Series& b) { return place(a) < place(b); });
  return series;
}

/// The results of some clips only.
Results resultsOf(const std::vector<StudyRow>& rows, const std::set<std::string>& clips) {
  std::vector<StudyRow> chosen;
  for (const StudyRow& row : rows)
    if (clips.contains(row.clip)) chosen.push_back(row);
  return Results(std::move(chosen));
}

}  // namespace

std::vector<RateCurve> rateCurves(const std::vector<StudyRow>& rows, const std::string& clip,
                                  const std::set<std::string>& complete) {
  const bool mean = clip.empty();
  std::set<std::string> clips = complete;
  if (!mean) clips = {clip};
  const Results results = resultsOf(rows, clips);
  std::vector<RateCurve> curves;
  for (const Series& series : inOrder(mean ? Results(rows).series() : results.series())) {
    RateCurve curve{.series = series, .mean = mean};
    if (mean)
      curve.line = results.mean_curve(series);
    else if (!results.clips().empty())
      curve.line = results.curve(results.clips().front(), series);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const StudyRow& row = rows[i];
      if (!row.measured || !series.has(row) || (!mean && row.clip != clip)) continue;
      const double eps_cm = row.measured->eps_cm(row.settings.weighting);
      if (eps_cm > 0) curve.points.push_back({row.measured->ratio, eps_cm, static_cast<int>(i)});
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace mocapress
