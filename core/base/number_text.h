// SPDX-License-Identifier: MIT
// Numbers in text that a program reads. printf and streams follow the locale and may write a comma
// for the decimal point; these do not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// With so many digits after the point: "2.50".
std::string fixed_text(double value, int decimals);

/// With at most so many significant digits, without zeros at the end: "2.5", "1e+06".
std::string significant_text(double value, int digits);

/// With as few digits as tell it from every other double: "0.1".
std::string shortest_text(double value);

/// The number that the whole text is; unset when it is none, or not finite.
std::optional<double> number_in(std::string_view text);

}  // namespace mocapress
