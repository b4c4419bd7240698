// SPDX-License-Identifier: MIT
#include "core/study/report_feet.h"

#include <cmath>

#include "core/report/html_table.h"

namespace mocapress {
namespace {

using namespace html;

constexpr double kShownRatio = 50;  // what r = 30 and r_IK = 16 of the paper's video come to

/// The same clip at the same size.
struct Pair {
  const StudyRow* without;
  const StudyRow* with;
};

const Series* held_series(const Results& results) {
  for (const Series& series : results.series())
    if (series.ik_ratio) return &series;
  return nullptr;
}

Pair pair_of(const Results& results, const StudiedClip& clip, const Series& held,
             const Target& target) {
  const Series* plain = results.find_series(held.method);
  return {plain ? results.row(clip, *plain, target) : nullptr, results.row(clip, held, target)};
}

/// The ratio nearest to kShownRatio at which feet were held.
std::optional<Target> shown_target(const Results& results) {
  std::optional<Target> nearest;
  const auto off = [](const Target& t) { return std::abs(std::log(t.value / kShownRatio)); };
  for (const StudyRow& row : results.rows())
    if (row.ik_ratio && row.measured && row.target.kind == Target::Kind::Ratio &&
        (!nearest || off(row.target) < off(*nearest)))
      nearest = row.target;
  return nearest;
}

std::string percent(double share) {
  const std::string text = fixed(100 * share, 0);
  return (share > 0 && text[0] != '-' ? "+" : "") + text + " %";
}

std::string line_of(const StudiedClip& clip, const Pair& pair, Weighting weighting) {
  const Measurement& without = *pair.without->measured;
  const Measurement& with = *pair.with->measured;
  const double before = without.footskate_cm.value_or(0);
  const double after = with.footskate_cm.value_or(0);
  return line(row_head(clip.title) + cell(fixed(with.ratio, 1) + ":1") +
              cell(fixed(without.eps_cm(weighting), 3)) + cell(fixed(with.eps_cm(weighting), 3)) +
              cell(percent(with.eps_cm(weighting) / without.eps_cm(weighting) - 1)) +
              cell(fixed(before, 1)) + cell(fixed(after, 1)) +
              cell(before > 0 ? percent(after / before - 1) : kNothing) +
              cell(with.knee_speed_ratio ? fixed(*with.knee_speed_ratio, 2) + " x" : kNothing));
}

}  // namespace

std::string held_feet_table(const Results& results) {
  const Series* held = held_series(results);
  const auto target = shown_target(results);
  if (!held || !target) return "";
  const std::string groups = head("") + head("") +
                             group("&#949;<sub>x</sub> (cm) without, with IK", 3) +
                             group("footskate (cm) without, with IK", 3) + head("");
  const std::string heads = head("Clip", attribute("class", "name")) + head("ratio") +
                            head("without") + head("with") + head("") + head("without") +
                            head("with") + head("") + head("knee");
  std::string body;
  for (const StudiedClip& clip : results.clips()) {
    const Pair pair = pair_of(results, clip, *held, *target);
    if (pair.without && pair.with && pair.with->measured->contacts > 0)
      body += line_of(clip, pair, results.weighting());
  }
  if (body.empty()) return "";
  return element("p", attribute("class", "muted"),
                 "Both at the same compression ratio: what the correction takes is missing "
                 "elsewhere. Knee: its greatest speed over that of the original.") +
         table(line(groups) + line(heads), body);
}

}  // namespace mocapress
