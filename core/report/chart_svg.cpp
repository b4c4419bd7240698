// SPDX-License-Identifier: MIT
#include "core/report/chart_svg.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/report/markup.h"

namespace mocapress {
namespace {

constexpr double kGuideEpsCm = 0.5;  // up to this error the paper saw no artifacts

/// Maps values to pixels on a logarithmic axis.
class LogAxis {
 public:
  LogAxis(double low, double high, double from_px, double to_px)
      : low_(low), high_(high), from_(from_px), to_(to_px) {}

  double at(double value) const {
    return from_ + (to_ - from_) * std::log(value / low_) / std::log(high_ / low_);
  }
  bool holds(double value) const { return value >= low_ * 0.999 && value <= high_ * 1.001; }

  /// The values of the axis labels: digits 1, 2 and 5 of each decade; in a short range 1 to 9, in a
  /// long one only 1.
  std::vector<double> ticks() const {
    constexpr double kLeastGap = 26;  // px
    const double decades = std::log10(high_ / low_);
    const bool dense = high_ / low_ < 8;
    const bool sparse = std::abs(to_ - from_) < 3 * kLeastGap * decades;
    std::vector<double> all;
    for (double decade = std::pow(10, std::floor(std::log10(low_))); decade <= high_; decade *= 10)
      for (const int digit : {1, 2, 3, 4, 5, 6, 7, 8, 9})
        if ((dense || digit == 1 || (!sparse && (digit == 2 || digit == 5))) &&
            holds(digit * decade))
          all.push_back(digit * decade);
    return all;
  }

 private:
  double low_, high_, from_, to_;
};

std::string text_at(double x, double y, std::string_view attributes, std::string_view content) {
  return element("text", attribute("x", px(x)) + attribute("y", px(y)) + std::string(attributes),
                 content);
}

std::string line_between(double x1, double y1, double x2, double y2, std::string_view css) {
  return element("path",
                 attribute("class", css) +
                     attribute("d", "M" + px(x1) + " " + px(y1) + "L" + px(x2) + " " + px(y2)),
                 "");
}

/// The outline of a series' marker: circle, square, triangle, diamond, triangle upside down or
/// hexagon.
std::string marker_path(int style, double x, double y, double r) {
  const auto polygon = [&](int corners, double turn, double size) {
    std::string d;
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / corners;
      d += (i == 0 ? "M" : "L") + px(x + size * std::cos(angle)) + " " +
           px(y + size * std::sin(angle));
    }
    return d + "Z";
  };
  switch (style % 6) {
    case 0:
      return polygon(16, 0, r);
    case 1:
      return polygon(4, std::numbers::pi / 4, r * 1.2);
    case 2:
      return polygon(3, -std::numbers::pi / 2, r * 1.35);
    case 3:
      return polygon(4, 0, r * 1.3);
    case 4:
      return polygon(3, std::numbers::pi / 2, r * 1.35);
    default:
      return polygon(6, 0, r * 1.1);
  }
}

std::string style_class(const ChartSeries& series, const char* part) {
  return std::string(part) + (series.paper ? " paper" : "") + " s" +
         std::to_string(series.style % kChartStyles);
}

class Drawing {
 public:
  Drawing(const Chart& chart, const ReportLanguage& say) : chart_(chart), say_(say) {
    for (const ChartSeries& series : chart.series)
      for (const Curve* curve : {&series.line, &series.markers})
        for (const CurvePoint& p : *curve) include(p);
    if (low_.ratio > high_.ratio) low_ = {1, 0.1}, high_ = {10, 1};
  }

  std::string draw() const {
    std::string content = axes();
    for (const ChartSeries& series : chart_.series) content += curve(series);
    if (chart_.direct_labels) content += labels();
    return element("svg",
                   attribute("class", "chart") +
                       attribute("viewBox", "0 0 " + px(chart_.width) + " " + px(chart_.height)) +
                       attribute("role", "img") + attribute("aria-label", chart_.label),
                   content);
  }

 private:
  void include(const CurvePoint& p) {
    low_ = {std::min(low_.ratio, p.ratio), std::min(low_.eps_cm, p.eps_cm)};
    high_ = {std::max(high_.ratio, p.ratio), std::max(high_.eps_cm, p.eps_cm)};
  }

  double left() const { return 52; }
  double right() const { return chart_.width - (chart_.direct_labels ? label_width() : 12); }
  double label_width() const {
    constexpr double kLetter = 7.6;  // px: average width of a bold letter
    std::size_t longest = 0;
    for (const ChartSeries& series : chart_.series)
      longest = std::max(longest, series.title.size());
    return 24 + kLetter * static_cast<double>(longest);
  }
  double top() const { return 10; }
  double bottom() const { return chart_.height - 42; }
  LogAxis x() const { return {low_.ratio / 1.08, high_.ratio * 1.08, left(), right()}; }
  LogAxis y() const { return {low_.eps_cm / 1.15, high_.eps_cm * 1.15, bottom(), top()}; }

  std::string axes() const {
    std::string content;
    for (const double tick : x().ticks()) {
      content += line_between(x().at(tick), top(), x().at(tick), bottom(), "grid");
      content += text_at(x().at(tick), bottom() + 16, attribute("text-anchor", "middle"),
                         format_shortest(tick) + ":1");
    }
    for (const double tick : y().ticks()) {
      content += line_between(left(), y().at(tick), right(), y().at(tick), "grid");
      content += text_at(left() - 7, y().at(tick) + 4, attribute("text-anchor", "end"),
                         format_shortest(tick));
    }
    if (y().holds(kGuideEpsCm))
      content += line_between(left(), y().at(kGuideEpsCm), right(), y().at(kGuideEpsCm), "guide");
    content += text_at((left() + right()) / 2, chart_.height - 6,
                       attribute("class", "axis") + attribute("text-anchor", "middle"),
                       say_("compression ratio %1 smaller", {"&#8594;"}));
    const double middle = (top() + bottom()) / 2;
    content += text_at(12, middle,
                       attribute("class", "axis") + attribute("text-anchor", "middle") +
                           attribute("transform", "rotate(-90 12 " + px(middle) + ")"),
                       "&#949;<tspan dy=\"3\" font-size=\"75%\">x</tspan><tspan dy=\"-3\">"
                       ", cm</tspan>");
    return content;
  }

  std::string curve(const ChartSeries& series) const {
    std::string content;
    if (series.line.size() > 1) {
      std::string d;
      for (const CurvePoint& p : series.line)
        d += (d.empty() ? "M" : "L") + px(x().at(p.ratio)) + " " + px(y().at(p.eps_cm));
      content +=
          element("path", attribute("class", style_class(series, "line")) + attribute("d", d), "");
    }
    for (const CurvePoint& p : series.markers)
      content += element(
          "path",
          attribute("class", style_class(series, "mark")) +
              attribute("d", marker_path(series.style, x().at(p.ratio), y().at(p.eps_cm),
                                         series.paper           ? 4.5
                                         : chart_.direct_labels ? 3.6
                                                                : 2.4)),
          element("title", "",
                  say_("%1: %2 cm at %3", {escaped(series.title), format_significant(p.eps_cm),
                                           ratio_text(p.ratio)})));
    return content;
  }

  /// Titles at the right ends of the lines, moved apart where they would overlap.
  std::string labels() const {
    struct Label {
      double x, y, wanted;
      const ChartSeries* series;
    };
    std::vector<Label> all;
    for (const ChartSeries& series : chart_.series)
      if (!series.line.empty() && !series.paper) {
        const double at = y().at(series.line.back().eps_cm);
        all.push_back({x().at(series.line.back().ratio), at, at, &series});
      }
    std::ranges::sort(all, [](auto& a, auto& b) { return a.wanted < b.wanted; });
    constexpr double kLineHeight = 17;
    double free = top() + 6;
    for (Label& label : all) free = (label.y = std::max(label.wanted, free)) + kLineHeight;
    double limit = bottom() - 4;
    for (auto label = all.rbegin(); label != all.rend(); ++label, limit -= kLineHeight)
      label->y = std::min(label->y, limit);
    std::string content;
    for (const Label& label : all) {
      const double at = right() + 12;
      content += line_between(label.x + 5, label.wanted, at - 4, label.y, "leader");
      content += text_at(at, label.y + 4, attribute("class", style_class(*label.series, "label")),
                         escaped(label.series->title));
    }
    return content;
  }

  const Chart& chart_;
  const ReportLanguage& say_;
  CurvePoint low_{1e300, 1e300};
  CurvePoint high_{0, 0};
};

}  // namespace

std::string draw(const Chart& chart, const ReportLanguage& say) {
  return Drawing(chart, say).draw();
}

std::string legend_mark(int style) {
  const std::string css = " s" + std::to_string(style % kChartStyles);
  return element(
      "svg",
      attribute("class", "sign") + attribute("viewBox", "0 0 26 12") +
          attribute("aria-hidden", "true"),
      line_between(1, 6, 25, 6, "line" + css) +
          element("path",
                  attribute("class", "mark" + css) + attribute("d", marker_path(style, 13, 6, 3.6)),
                  ""));
}

}  // namespace mocapress
