// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// Escapes a text for HTML and SVG, including attributes.
std::string escaped(std::string_view text);

/// Makes "<tag attributes>content</tag>". Content must be markup: text has to be escaped first.
/// With nested calls, tags are always balanced.
std::string element(std::string_view tag, std::string_view attributes, std::string_view content);

/// Makes ' name="value"' and escapes the value.
std::string attribute(std::string_view name, std::string_view value);

/// Formats a number with `decimals` decimals.
std::string fixed(double value, int decimals);

/// Formats a length in pixels for a drawing.
std::string px(double value);

/// Formats a number with about three significant digits and no exponent: "0.051", "3.42", "128".
std::string format_significant(double value);

/// Formats a number without trailing zeros: "0.26", "30".
std::string format_shortest(double value);

/// Formats a ratio as "28.5:1".
std::string ratio_text(double ratio);

}  // namespace mocapress

/// Makes parts of HTML pages.
namespace mocapress::html {

/// Shown in place of a missing value.
inline constexpr const char* kNothing = "&#8211;";

/// The name of the paper's error measure, eps_x.
inline constexpr const char* kEpsX = "&#949;<sub>x</sub>";

inline std::string cell(std::string_view content, std::string_view css = "") {
  return element("td", css.empty() ? "" : attribute("class", css), content);
}

inline std::string head(std::string_view content, std::string_view attributes = "") {
  return element("th", attributes, content);
}

/// The head of a column of text.
inline std::string text_head(std::string_view content) {
  return head(content, attribute("class", "name"));
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

/// A paragraph of grey text.
inline std::string muted(std::string_view content) {
  return element("p", attribute("class", "muted"), content);
}

/// A number in large letters with its meaning below. `tone` colours it: "doubtful" amber, "wrong"
/// red; otherwise it has the text's colour.
inline std::string tile(std::string_view figure, std::string_view meaning,
                        std::string_view tone = "") {
  return element("div", attribute("class", tone.empty() ? "tile" : "tile " + std::string(tone)),
                 element("b", "", figure) + element("span", "", meaning));
}

/// The beginning of a page. Its contents follow, and then "</main></body></html>".
inline std::string page_begin(std::string_view language, std::string_view title,
                              std::string_view style) {
  return "<!DOCTYPE html>\n<html" + attribute("lang", language) +
         "><head><meta charset=\"utf-8\"/><meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"/>" +
         element("title", "", title) + element("style", "", style) + "</head><body><main>";
}

/// A head over several columns.
inline std::string group(std::string_view title, std::size_t columns,
                         std::string_view css = "group") {
  return head(title, attribute("colspan", std::to_string(columns)) + attribute("class", css));
}

}  // namespace mocapress::html
