// SPDX-License-Identifier: MIT
#include "core/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace mocapress {
namespace {

template <typename... Format>
std::string text_of(double value, Format... format) {
  std::array<char, 512> buffer;  // the largest double has 309 digits before the point
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
  return error == std::errc() ? std::string(buffer.data(), end) : std::string();
}

}  // namespace

std::string fixed_text(double value, int decimals) {
  return text_of(value, std::chars_format::fixed, decimals);
}

std::string significant_text(double value, int digits) {
  return text_of(value, std::chars_format::general, digits);
}

std::string shortest_text(double value) {
  return text_of(value);
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace mocapress
