// SPDX-License-Identifier: MIT
#include "core/metrics/sight_limits_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace mocapress {
namespace {

constexpr const char* kDistance = "distance_m";
constexpr const char* kLeast = "least";
constexpr const char* kShare = "share";

[[noreturn]] void refuse(const std::string& why) {
  throw Error(why);
}

double number(const Json& value, const std::string& key) {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    refuse("\"" + key + "\" is not a number");
  return value.get<double>();
}

Cue cue_named(const std::string& key) {
  for (std::size_t c = 0; c < kCues; ++c)
    if (name(static_cast<Cue>(c)) == key) return static_cast<Cue>(c);
  refuse("\"" + key + "\" is unknown");
}

void read_limit(const Json& json, const std::string& cue, CueLimit& limit) {
  if (!json.is_object()) refuse("\"" + cue + "\" is not a JSON object");
  for (const auto& [key, value] : json.items()) {
    const std::string place = cue + "." + key;
    if (key == kLeast) {
      limit.least = number(value, place);
      if (limit.least <= 0) refuse("\"" + place + "\" is not above 0");
    } else if (key == kShare) {
      limit.share = number(value, place);
      if (limit.share < 0) refuse("\"" + place + "\" is below 0");
    } else {
      refuse("\"" + place + "\" is unknown");
    }
  }
}

}  // namespace

Json to_json(const SightLimits& limits, bool all) {
  const SightLimits built_in;
  Json json = Json::object();
  if (all || limits.distance_m != built_in.distance_m) json[kDistance] = limits.distance_m;
  for (std::size_t c = 0; c < kCues; ++c) {
    const CueLimit& limit = limits.of_cues[c];
    const CueLimit& usual = built_in.of_cues[c];
    if (!all && limit == usual) continue;
    Json& one = json[std::string(name(static_cast<Cue>(c)))];
    one[kLeast] = limit.least;
    if (limit.share > 0 || usual.share > 0) one[kShare] = limit.share;
  }
  return json;
}

SightLimits limits_from(const Json& json, double distance_m) {
  if (!json.is_object()) refuse("what should be limits is not a JSON object");
  SightLimits limits{.distance_m = distance_m};
  for (const auto& [key, value] : json.items()) {
    if (key != kDistance) {
      read_limit(value, key, limits.of(cue_named(key)));
      continue;
    }
    limits.distance_m = number(value, key);
    if (limits.distance_m < kLeastDistance || limits.distance_m > kMostDistance)
      refuse("\"distance_m\" is not from " + shortest_text(kLeastDistance) + " to " +
             shortest_text(kMostDistance));
  }
  return limits;
}

std::string limits_to_text(const SightLimits& limits) {
  Json json = to_json(limits, true);
  json.erase(kDistance);
  return dumped(json, 2) + '\n';
}

SightLimits limits_from_text(const std::string& file, std::string_view text, double distance_m) {
  constexpr JsonLimits kSmall = {.depth = 4, .values = 200};
  const Json json = parse_json(file, text, kSmall);
  try {
    return limits_from(json, distance_m);
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
}

}  // namespace mocapress
