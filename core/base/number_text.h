// SPDX-License-Identifier: MIT
// Numbers in text that a program reads. printf and streams follow the locale and may write a comma
// for the decimal point; these do not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// Formats a value with this number of digits after the point: "2.50".
std::string fixed_text(double value, int decimals);

/// Formats a value with at most this number of significant digits, without trailing zeros: "2.5",
/// "1e+06".
std::string significant_text(double value, int digits);

/// The shortest text that tells the value from every other double: "0.1".
std::string shortest_text(double value);

/// The number that makes up the whole text; unset if it is none or not finite.
std::optional<double> number_in(std::string_view text);

}  // namespace mocapress
