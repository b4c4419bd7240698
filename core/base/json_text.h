// SPDX-License-Identifier: MIT
// Parses and writes JSON. The library's parser and writer are templates that take seconds to
// compile, so they are compiled here only.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace mocapress {

using Json = nlohmann::ordered_json;  // keeps the order in which keys are read or set

/// Limits on JSON from untrusted files.
struct JsonLimits {
  int depth;           // how deep braces and brackets may nest
  std::size_t values;  // each takes some 50 bytes of memory
};

/// Parses JSON. Throws InputError with the line and column at which `text` stops being JSON.
Json parse_json(const std::string& file, std::string_view text);

/// Parses JSON within limits. Throws InputError for a text that exceeds them, before memory is
/// allocated for it.
Json parse_json(const std::string& file, std::string_view text, const JsonLimits& limits);

/// Writes JSON, on one line unless `indent` is given. File names may have bytes that are not UTF-8:
/// these are replaced.
std::string dumped(const Json& json, int indent = -1);

}  // namespace mocapress
