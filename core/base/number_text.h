// SPDX-License-Identifier: MIT
// Formats and parses numbers in text for programs, always with a decimal point. printf and streams
// follow the locale, which may have a decimal comma.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// Formats a value with `decimals` digits after the point: "2.50".
std::string fixed_text(double value, int decimals);

/// Formats a value with at most `digits` significant digits, without trailing zeros: "2.5",
/// "1e+06".
std::string significant_text(double value, int digits);

/// Formats a value with the fewest digits that distinguish it from every other double: "0.1".
std::string shortest_text(double value);

/// Parses a text that is a number from beginning to end. Unset for any other text, and for infinity
/// and NaN.
std::optional<double> number_in(std::string_view text);

}  // namespace mocapress
