// SPDX-License-Identifier: MIT
// Parses and writes JSON. The library's parser and writer are templates that take seconds to
// compile, so they are compiled here only.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace mocapress {

using Json = nlohmann::ordered_json;  // keys are written in the order they were read or set

/// Limits on JSON from untrusted files.
struct JsonLimits {
  int depth;           // braces and brackets within each other
  std::size_t values;  // each takes some 50 bytes of memory
};

/// Parses JSON. Throws InputError, with line and column where `text` ceases to be JSON.
Json parse_json(const std::string& file, std::string_view text);

/// Parses JSON from `text` within limits. Throws InputError for a text that exceeds them, before it
/// takes memory.
Json parse_json(const std::string& file, std::string_view text, const JsonLimits& limits);

/// Writes JSON, on one line unless there is an indent. File names may have bytes that are not
/// UTF-8: these are replaced.
std::string dumped(const Json& json, int indent = -1);

}  // namespace mocapress
