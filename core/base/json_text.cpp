// SPDX-License-Identifier: MIT
#include "core/base/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace mocapress {

namespace {

Json parse(const std::string& file, std::string_view text, const Json::parser_callback_t& visit) {
  try {
    return Json::parse(text, visit);
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, error.byte == 0 ? 0 : error.byte - 1);
    const auto line = static_cast<int>(std::ranges::count(before, '\n')) + 1;
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 if there is none
    throw InputError(file, line, static_cast<int>(before.size() - line_begin) + 1,
                     "is not JSON from here on");
  } catch (const Json::exception&) {
    throw InputError(file, 0, 0, "holds a number that is too large");
  }
}

}  // namespace

Json parse_json(const std::string& file, std::string_view text) {
  return parse(file, text, nullptr);
}

Json parse_json(const std::string& file, std::string_view text, const JsonLimits& limits) {
  std::size_t values = 0;
  return parse(file, text, [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > limits.depth)
      throw InputError(file, 0, 0,
                       "nests its JSON more than " + std::to_string(limits.depth) + " deep");
    if (++values > limits.values) throw InputError(file, 0, 0, "holds too many JSON values");
    return true;
  });
}

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mocapress
