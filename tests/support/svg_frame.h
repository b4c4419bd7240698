// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <regex>
#include <string>

#include "core/base/number_text.h"

namespace mocapress::test {

/// The bounding box of the end points of lines and arcs in SVG paths.
struct DrawnExtent {
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  double right = -left;
  double bottom = -left;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// The extent of every `d` in some markup; unset if one has more than commands and numbers.
inline std::optional<DrawnExtent> drawn_extent(const std::string& markup) {
  static const std::regex kPath(R"re( d="([^"]*)")re");
  // A letter has two numbers, except A with seven, of which the last two are a point.
  static const std::regex kStep(R"(([ML]|A\S+ \S+ 0 [01] [01] )(-?\d+\.\d) (-?\d+\.\d)|Z)");
  DrawnExtent extent;
  for (std::sregex_iterator path(markup.begin(), markup.end(), kPath), end; path != end; ++path) {
    const std::string d = (*path)[1];
    std::size_t length = 0;
    for (std::sregex_iterator step(d.begin(), d.end(), kStep); step != end; ++step) {
      length += static_cast<std::size_t>(step->length());
      if (!(*step)[2].matched) continue;
      const double x = number_in((*step)[2].str()).value();
      const double y = number_in((*step)[3].str()).value();
      extent = {std::min(extent.left, x), std::min(extent.top, y), std::max(extent.right, x),
                std::max(extent.bottom, y)};
    }
    if (length != d.size()) return std::nullopt;
  }
  return extent;
}

/// The first picture of a page that does not fill its frame, as a text; empty: all do. A chart must
/// take half of both sides. In scenes, the figure without the floor must take a quarter of the
/// width or height.
inline std::string misfit(const std::string& html) {
  static const std::regex kPicture(R"re(<svg class="(scene|chart)" viewBox="([^"]*)")re");
  static const std::regex kFrame(R"re(0 0 (\d+\.\d) (\d+\.\d))re");
  for (std::sregex_iterator at(html.begin(), html.end(), kPicture), end; at != end; ++at) {
    const std::string box = (*at)[2];
    std::smatch sides;
    if (!std::regex_match(box, sides, kFrame)) return "no frame: " + box;
    const double width = number_in(sides[1].str()).value();
    const double height = number_in(sides[2].str()).value();
    const auto begin = static_cast<std::size_t>(at->position());
    const std::string picture = html.substr(begin, html.find("</svg>", begin) - begin);
    const auto all = drawn_extent(picture);
    if (!all) return "no path in " + box;
    const bool is_chart = (*at)[1] == "chart";
    if (is_chart && (!(all->width() >= width / 2) || !(all->height() >= height / 2)))
      return "less than half is filled of " + box;
    const std::size_t figure = picture.find("<g class=\"figure\">");
    if (figure == std::string::npos) continue;
    const auto body = drawn_extent(picture.substr(figure, picture.find("</g>", figure) - figure));
    const double share = std::max(body->width() / width, body->height() / height);
    if (!(share >= 0.25) || body->left > width || body->right < 0 || body->top > height ||
        body->bottom < 0)
      return "the figure is not in sight in " + box + ", but from " + std::to_string(body->left) +
             ", " + std::to_string(body->top) + " to " + std::to_string(body->right) + ", " +
             std::to_string(body->bottom);
  }
  return "";
}

}  // namespace mocapress::test
