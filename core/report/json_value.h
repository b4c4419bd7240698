// SPDX-License-Identifier: MIT
#pragma once
// Reads and writes single values of rows of results. A missing value is null in JSON and empty in
// CSV.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/base/printable.h"
#include "core/formats/text_cursor.h"

namespace mocapress {

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

inline Json text_or_null(std::string_view text) {
  return text.empty() ? Json() : Json(text);
}

/// Reads a value; unset if it is null. Throws the JSON library's exceptions, also for a missing
/// key.
template <typename T>
std::optional<T> optional_at(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

/// Makes a field for comma-separated values (RFC 4180) of a file's or joint's name. Control
/// characters become visible. Text that a spreadsheet would take for a formula gets an apostrophe
/// in front.
inline std::string csv_quoted(const std::string& field) {
  constexpr std::string_view kFormulas = "=+-@";
  std::string text = printable(field);
  if (!text.empty() && kFormulas.find(text.front()) != std::string_view::npos &&
      !parse_number(text))
    text.insert(text.begin(), '\'');
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace mocapress
