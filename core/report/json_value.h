// SPDX-License-Identifier: MIT
#pragma once
// What a row of results writes for a value that may be missing: null.

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace mocapress {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

inline Json text_or_null(std::string_view text) {
  return text.empty() ? Json() : Json(text);
}

/// Nothing where null stands. Throws like the JSON library does, for a missing key too.
template <typename T>
std::optional<T> optional_at(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

}  // namespace mocapress
