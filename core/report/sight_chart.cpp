// SPDX-License-Identifier: MIT
#include "core/report/sight_chart.h"

#include <algorithm>
#include <numeric>

#include "core/report/markup.h"

namespace mocapress {
namespace {

constexpr Eigen::Index kMostColumns = 240;
constexpr std::size_t kMostJoints = 8;
constexpr double kNames = 92;  // px: room for names
constexpr double kWidth = 520;
constexpr double kLine = 15;
constexpr double kBar = 11;

/// A digit for each column: the worst of the windows of time that it covers.
std::string sights_of(const Eigen::VectorXf& times_noticed) {
  const Eigen::Index columns = std::min(times_noticed.size(), kMostColumns);
  std::string sights;
  for (Eigen::Index column = 0; column < columns; ++column) {
    const Eigen::Index first = column * times_noticed.size() / columns;
    const Eigen::Index end = (column + 1) * times_noticed.size() / columns;
    const float most = times_noticed.segment(first, end - first).maxCoeff();
    sights += static_cast<char>('0' + static_cast<int>(sight_of(static_cast<double>(most))));
  }
  return sights;
}

std::string rectangle(double x, double y, double width, double height, std::string_view css,
                      std::string_view title = "") {
  return element("rect",
                 attribute("class", css) + attribute("x", fixed(x, 1)) +
                     attribute("y", fixed(y, 1)) + attribute("width", fixed(width, 1)) +
                     attribute("height", fixed(height, 1)),
                 title.empty() ? "" : element("title", "", escaped(title)));
}

std::string text(double x, double y, std::string_view anchor, std::string_view content) {
  return element(
      "text",
      attribute("x", fixed(x, 1)) + attribute("y", fixed(y, 1)) + attribute("text-anchor", anchor),
      escaped(content));
}

/// The bars of a line. Borderline bars have half height, so that colour is not needed to tell them
/// from visible ones.
std::string bars(const ReportLanguage& say, const SightLine& line, double y, double seconds) {
  const std::string who = line.joint.empty() ? "" : line.joint + ", ";
  const double columns = static_cast<double>(line.sights.size());
  std::string all = rectangle(kNames, y, kWidth - kNames, kBar, "seen0");
  for (std::size_t from = 0, to = 0; from < line.sights.size(); from = to) {
    to = std::min(line.sights.find_first_not_of(line.sights[from], from), line.sights.size());
    if (line.sights[from] != '1' && line.sights[from] != '2') continue;
    const bool is_visible = line.sights[from] == '2';
    const double height = is_visible ? kBar : kBar / 2;
    const double share = static_cast<double>(from) / columns;
    const double end = static_cast<double>(to) / columns;
    all +=
        rectangle(kNames + share * (kWidth - kNames), y + kBar - height,
                  (end - share) * (kWidth - kNames), height, is_visible ? "seen2" : "seen1",
                  who + say("%1 to %2 s: %3", {fixed(share * seconds, 1), fixed(end * seconds, 1),
                                               say(is_visible ? "visible" : "borderline")}));
  }
  return all;
}

}  // namespace

SightChart sight_chart(const SightTable& table, const Skeleton& skeleton) {
  if (table.windows() == 0) return {};
  SightChart chart = {{"", sights_of(table.times_noticed.rowwise().maxCoeff())}};
  const Eigen::VectorXf worst = table.times_noticed.colwise().maxCoeff();
  std::vector<int> joints(worst.size());
  std::iota(joints.begin(), joints.end(), 0);
  std::ranges::stable_sort(joints, [&](int a, int b) { return worst(a) > worst(b); });
  joints.resize(std::min(joints.size(), kMostJoints));
  for (const int joint : joints)
    if (sight_of(static_cast<double>(worst(joint))) != Sight::NotVisible)
      chart.push_back({skeleton.joint(joint).name, sights_of(table.times_noticed.col(joint))});
  return chart;
}

std::string draw(const SightChart& chart, double seconds, const std::string& label,
                 const ReportLanguage& say) {
  std::string content = element("title", "", escaped(label));
  double y = 2;
  for (const SightLine& line : chart) {
    content +=
        text(kNames - 6, y + kBar - 1.5, "end", line.joint.empty() ? say("any") : line.joint) +
        bars(say, line, y, seconds);
    y += kLine;
  }
  content +=
      text(kNames, y + 11, "start", "0 s") + text(kWidth, y + 11, "end", fixed(seconds, 1) + " s");
  return element("svg",
                 attribute("class", "sights") + attribute("role", "img") +
                     attribute("viewBox", "0 0 " + fixed(kWidth, 0) + " " + fixed(y + 15, 0)),
                 content);
}

}  // namespace mocapress
