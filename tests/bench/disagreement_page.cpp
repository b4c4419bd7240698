// SPDX-License-Identifier: MIT
#include "tests/bench/disagreement_page.h"

#include <algorithm>

#include "core/report/markup.h"
#include "core/report/report_style.h"

namespace mocapress {
namespace {

// Aligned with the chart of visibility below.
constexpr double kLeft = 92;  // px
constexpr double kWidth = 520;
constexpr double kHeight = 90;
constexpr double kTop = 10;

/// A curve that shows the worst frame of each pixel.
std::string curve(const Eigen::VectorXd& cm, double top_cm, std::string_view style) {
  const Eigen::Index columns = std::min<Eigen::Index>(cm.size(), static_cast<int>(kWidth - kLeft));
  std::string path;
  for (Eigen::Index column = 0; column < columns; ++column) {
    const Eigen::Index first = column * cm.size() / columns;
    const Eigen::Index end = (column + 1) * cm.size() / columns;
    const double worst = cm.segment(first, end - first).maxCoeff();
    const double share = (static_cast<double>(column) + 0.5) / static_cast<double>(columns);
    path += (path.empty() ? "M" : "L") + fixed(kLeft + share * (kWidth - kLeft), 1) + " " +
            fixed(kHeight - (kHeight - kTop) * worst / top_cm, 1);
  }
  return element("path", attribute("class", style) + attribute("d", path), "");
}

std::string text(double y, std::string_view content) {
  return element("text",
                 attribute("x", fixed(kLeft - 6, 0)) + attribute("y", fixed(y, 0)) +
                     attribute("text-anchor", "end"),
                 content);
}

/// Draws curves with the same scale for both clips.
std::string curves(const LookedAt& clip, double top_cm) {
  return element("svg",
                 attribute("class", "sights") + attribute("role", "img") +
                     attribute("viewBox", "0 0 " + fixed(kWidth, 0) + " " + fixed(kHeight + 2, 0)),
                 element("title", "", "Error over time: largest, and root mean square") +
                     text(kTop + 4, format_significant(top_cm) + " cm") + text(kHeight, "0") +
                     curve(clip.max_cm, top_cm, "line s5") + curve(clip.rms_cm, top_cm, "line s0"));
}

std::string scene(const WorstPose& pose, const std::string& caption) {
  return element("figure", "",
                 worst_scene(pose, caption) + element("figcaption", "", escaped(caption)));
}

std::string drawn(const LookedAt& clip, double top_cm) {
  return element(
      "figure", "",
      element("h3", "", escaped(clip.title)) +
          element("p", "", escaped(clip.figures) + "<br/>" + escaped(clip.reason)) +
          curves(clip, top_cm) + draw(clip.sights, clip.seconds, "Visibility") +
          element("div", attribute("class", "pair"),
                  scene(clip.furthest, "Bone end furthest off: " + clip.furthest.landmark +
                                           ", frame " + std::to_string(clip.furthest.frame)) +
                      scene(clip.most_seen, "Most seen: " + clip.most_seen.landmark + ", frame " +
                                                std::to_string(clip.most_seen.frame))));
}

}  // namespace

std::string disagreement_page(const std::vector<Disagreement>& all) {
  std::string body =
      element("h1", "", "Clips that RMS, maximum and visibility rank differently") +
      element("p", attribute("class", "muted"),
              "Grey: the largest error of any point of the skin at every frame. Red: root mean "
              "square. Below: visibility. " +
                  std::string(kSightLegend) +
                  " Poses: the original in grey, the decoded one in red.");
  for (const Disagreement& one : all) {
    const double top_cm = std::max(one.better.max_cm.maxCoeff(), one.worse.max_cm.maxCoeff());
    body += element("section", "",
                    element("h2", "", escaped(one.title)) +
                        element("div", attribute("class", "pair"),
                                drawn(one.better, top_cm) + drawn(one.worse, top_cm)));
  }
  return "<!DOCTYPE html>\n" +
         element(
             "html", attribute("lang", "en"),
             "<head><meta charset=\"utf-8\"/>" +
                 element("title", "", "Clips that RMS, maximum and visibility rank differently") +
                 element("style", "", kReportStyle) + "</head>" +
                 element("body", "", element("main", "", body))) +
         "\n";
}

}  // namespace mocapress
