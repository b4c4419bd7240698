// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/report/markup.h"

/// The parts of an HTML table.
namespace mocapress::html {

/// Stands where there is no figure.
inline constexpr const char* kNothing = "&#8211;";

inline std::string cell(std::string_view content, std::string_view css = "") {
  return element("td", css.empty() ? "" : attribute("class", css), content);
}

inline std::string head(std::string_view content, std::string_view attributes = "") {
  return element("th", attributes, content);
}

inline std::string row_head(std::string_view text) {
  return head(escaped(text), attribute("scope", "row"));
}

inline std::string line(std::string_view cells, std::string_view attributes = "") {
  return element("tr", attributes, cells);
}

inline std::string table(std::string_view heads, std::string_view body) {
  return element("div", attribute("class", "scroll"),
                 element("table", "", element("thead", "", heads) + element("tbody", "", body)));
}

/// A head over several columns.
inline std::string group(std::string_view title, std::size_t columns,
                         std::string_view css = "group") {
  return head(title, attribute("colspan", std::to_string(columns)) + attribute("class", css));
}

}  // namespace mocapress::html
