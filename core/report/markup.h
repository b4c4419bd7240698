// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace mocapress {

/// Text as it may stand in HTML and SVG, in attributes too.
std::string escaped(std::string_view text);

/// "<tag attributes>content</tag>". Content is markup: escape what is not. Nested calls make a page
/// whose tags are balanced by construction.
std::string element(std::string_view tag, std::string_view attributes, std::string_view content);

/// ' name="value"', the value escaped.
std::string attribute(std::string_view name, std::string_view value);

/// With so many decimals.
std::string fixed(double value, int decimals);

/// A length on a drawing.
std::string px(double value);

/// With about three significant digits, never an exponent: "0.051", "3.42", "128".
std::string format_significant(double value);

/// As it was given, without zeros at the end: "0.26", "30".
std::string format_shortest(double value);

/// "28.5:1".
std::string ratio_text(double ratio);

}  // namespace mocapress
