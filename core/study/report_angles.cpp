// SPDX-License-Identifier: MIT
#include "core/study/report_angles.h"

#include <cmath>

#include "core/report/html_table.h"
#include "core/study/published_figures.h"
#include "core/study/report_tables.h"

namespace mocapress {
namespace {

using namespace html;

/// The one of a kind that is nearest to `value`.
std::optional<Target> nearest_target(const Results& results, Target::Kind kind, double value) {
  std::optional<Target> nearest;
  const auto off = [&](const Target& target) { return std::abs(std::log(target.value / value)); };
  for (const StudyRow& row : results.rows())
    if (row.measured && row.target.kind == kind && (!nearest || off(row.target) < off(*nearest)))
      nearest = row.target;
  return nearest;
}

std::optional<Target> angle_target(const Results& results) {
  const auto ratio = nearest_target(results, Target::Kind::Ratio, kPublishedVideoRatio);
  return ratio ? ratio : nearest_target(results, Target::Kind::Error, headline_eps_cm(results));
}

std::string angle_target_text(const Target& target) {
  return target.kind == Target::Kind::Ratio
             ? format_shortest(target.value) + ":1"
             : "&#949;<sub>x</sub> = " + format_shortest(target.value) + " cm";
}

std::string degrees_text(const std::optional<double>& value) {
  return value ? format_significant(*value) + "&#176;" : kNothing;
}

std::string angle_cell(const BodyFigures& body) {
  std::string text = degrees_text(body.angle_rms_degrees);
  if (body.head_degrees || body.hand_degrees)
    text += element(
        "small", "",
        " (" + degrees_text(body.head_degrees) + ", " + degrees_text(body.hand_degrees) + ")");
  return cell(text);
}

}  // namespace

std::string angle_table(const Results& results) {
  const auto target = angle_target(results);
  if (!target) return "";
  std::string heads = head("Clip", attribute("class", "name"));
  for (const Series& series : results.series()) heads += head(escaped(series.title));
  std::string body;
  for (const StudiedClip& clip : results.clips()) {
    std::string cells = row_head(clip.title);
    for (const Series& series : results.series()) {
      const StudyRow* row = results.row(clip, series, *target);
      cells += row ? angle_cell(row->measured->body) : cell(kNothing);
    }
    body += line(cells);
  }
  return element("p", attribute("class", "muted"),
                 "Angle in the world between a joint&#8217;s rotation and the original&#8217;s, "
                 "root mean square over frames and all joints; in brackets of the head and of the "
                 "hands, where they are known by their names. At " +
                     angle_target_text(*target) + ".") +
         table(line(heads), body);
}

}  // namespace mocapress
