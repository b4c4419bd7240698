// SPDX-License-Identifier: MIT
#include "core/mocapress/settings_json.h"

#include <algorithm>
#include <climits>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/metrics/sight_limits_json.h"

namespace mocapress {
namespace {

constexpr std::string_view kFound = "auto";
constexpr const char* kContacts = "contacts";  // among the names of importance
constexpr const char* kRanges = "importance_ranges";

/// Takes the values of an object's keys. A key that nobody took is a mistake, and end() refuses it.
class Keys {
 public:
  Keys(const Json& json, std::string of) : json_(json), of_(std::move(of)) {
    if (!json.is_object()) throw Error(of_ + " is not a JSON object");
  }

  /// Returns the key's value; nullptr if the key is missing.
  const Json* take(const char* key) {
    taken_.emplace_back(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
  }

  std::string text(const char* key, const std::string& otherwise) {
    const Json* value = take(key);
    if (!value) return otherwise;
    if (!value->is_string()) refuse(key, "is not a text");
    return value->get<std::string>();
  }

  double number(const char* key, double otherwise) {
    const Json* value = take(key);
    if (!value) return otherwise;
    if (!value->is_number()) refuse(key, "is not a number");
    return value->get<double>();
  }

  /// Returns a frame; -1 if the key is missing.
  int frame(const char* key) {
    const Json* value = take(key);
    if (!value) return -1;
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() > INT_MAX)
      refuse(key, "is not a frame");
    return value->get<int>();
  }

  template <typename Enum>
  Enum word(const char* key, Enum otherwise, std::initializer_list<Enum> values) {
    const std::string text = this->text(key, std::string(name(otherwise)));
    std::string known;
    for (const Enum value : values) {
      if (name(value) == text) return value;
      known.append(known.empty() ? "" : ", ").append(name(value));
    }
    refuse(key, "is \"" + text + "\", not one of " + known);
  }

  [[noreturn]] void refuse(const char* key, const std::string& why) const {
    throw Error(of_ + ": \"" + key + "\" " + why);
  }

  void end() const {
    for (const auto& [key, value] : json_.items())
      if (std::ranges::find(taken_, key) == taken_.end())
        throw Error(of_ + ": \"" + key + "\" is unknown");
  }

 private:
  const Json& json_;
  std::string of_;
  std::vector<std::string> taken_;
};

Json to_json(const CorrectionSettings& correction) {
  return {{"ratio", correction.ratio ? Json(*correction.ratio) : Json(kFound)},
          {"effectors", correction.effectors},
          {"solver", name(correction.solver)},
          {"at", name(correction.at)}};
}

CorrectionSettings correction_from(const Json& json, const std::string& of) {
  Keys keys(json, of + ": \"ik\"");
  CorrectionSettings correction;
  const Json* ratio = keys.take("ratio");
  if (ratio && ratio->is_number())
    correction.ratio = ratio->get<double>();
  else if (ratio && *ratio != kFound)
    keys.refuse("ratio", "is neither a number nor \"auto\"");
  if (const Json* effectors = keys.take("effectors")) {
    if (!effectors->is_array()) keys.refuse("effectors", "is not a list of names");
    for (const Json& effector : *effectors) {
      if (!effector.is_string()) keys.refuse("effectors", "is not a list of names");
      correction.effectors.push_back(effector.get<std::string>());
    }
  }
  correction.solver =
      keys.word("solver", correction.solver, {IkSolver::CyclicDescent, IkSolver::NearestPose});
  correction.at = keys.word("at", correction.at, {CorrectAt::EveryFrame, CorrectAt::Contacts});
  keys.end();
  return correction;
}

Target target_from(const Json& json, const std::string& of) {
  Keys keys(json, of + ": \"target\"");
  Target target{Target::Kind::Error, 0};
  target.kind = keys.word("kind", target.kind,
                          {Target::Kind::Ratio, Target::Kind::CoefficientRatio, Target::Kind::Size,
                           Target::Kind::Error, Target::Kind::MaxError, Target::Kind::Visibility});
  target.value = keys.number("value", target.kind == Target::Kind::Visibility ? 1 : 0);
  keys.end();
  return target;
}

Json to_json(const NamedImportance& importance) {
  Json json = Json::object();
  for (const auto& [name, factor] : importance.factors) json[name] = factor;
  if (importance.contacts > 0) json[kContacts] = importance.contacts;
  return json;
}

NamedImportance importance_from(const Json& json, const Keys& keys) {
  NamedImportance importance;
  if (!json.is_object()) keys.refuse("importance", "is not a JSON object");
  for (const auto& [name, factor] : json.items()) {
    if (!factor.is_number()) keys.refuse("importance", "of " + name + " is not a number");
    if (name == kContacts)
      importance.contacts = factor.get<double>();
    else
      importance.set(name, factor.get<double>());
  }
  return importance;
}

Json to_json(const std::vector<ContactSetting>& contacts) {
  Json json = Json::array();
  for (const ContactSetting& contact : contacts)
    json.push_back({{"joint", contact.point},
                    {"first_frame", contact.first_frame},
                    {"last_frame", contact.last_frame}});
  return json;
}

std::vector<ContactSetting> contacts_from(const Json& json, const Keys& keys,
                                          const std::string& of) {
  std::vector<ContactSetting> contacts;
  if (!json.is_array()) keys.refuse(kContacts, "is not a list of contacts");
  for (const Json& one : json) {
    Keys contact(one, of + ": a contact");
    ContactSetting read{contact.text("joint", ""), contact.frame("first_frame"),
                        contact.frame("last_frame")};
    contact.end();
    if (read.point.empty() || read.first_frame < 0 || read.last_frame < read.first_frame)
      keys.refuse(kContacts, "is not a list of joints with a first and a last frame");
    contacts.push_back(std::move(read));
  }
  return contacts;
}

Json to_json(const std::vector<ImportantRange>& ranges) {
  Json json = Json::array();
  for (const ImportantRange& range : ranges)
    json.push_back({{"first_frame", range.first_frame},
                    {"last_frame", range.last_frame},
                    {"factor", range.factor}});
  return json;
}

std::vector<ImportantRange> ranges_from(const Json& json, const Keys& keys, const std::string& of) {
  std::vector<ImportantRange> ranges;
  if (!json.is_array()) keys.refuse(kRanges, "is not a list of ranges");
  for (const Json& one : json) {
    Keys range(one, of + ": a range");
    const ImportantRange read{range.frame("first_frame"), range.frame("last_frame"),
                              range.number("factor", 0)};
    range.end();
    if (read.first_frame < 0 || read.last_frame < read.first_frame)
      keys.refuse(kRanges, "is not a list of ranges with a first and a last frame");
    ranges.push_back(read);
  }
  return ranges;
}

Json to_json(const Promises& promises) {
  Json json = Json::object();
  for (const PromiseKey& promise : kPromiseKeys)
    if (const auto& bound = promises.*promise.bound) json[promise.key] = *bound;
  return json;
}

Promises promises_from(const Json& json, const std::string& of) {
  Keys keys(json, of + ": \"promises\"");
  Promises promises;
  for (const PromiseKey& promise : kPromiseKeys)
    if (json.contains(promise.key)) promises.*promise.bound = keys.number(promise.key, 0);
  keys.end();
  return promises;
}

SightLimits limits_from(const Json& json, const std::string& of) {
  try {
    return mocapress::limits_from(json);
  } catch (const Error& error) {
    throw Error(of + ": \"limits\": " + error.what());
  }
}

std::uint64_t seed_from(const Json& json, const Keys& keys) {
  if (!json.is_number_unsigned()) keys.refuse("seed", "is not a whole number");
  return json.get<std::uint64_t>();
}

/// Reads settings; does not call check().
Settings read_settings(const Json& json) {
  Settings settings;
  settings.name = Keys(json, "what should be settings").text("name", "");
  const std::string of =
      settings.name.empty() ? "settings" : "the preset \"" + settings.name + "\"";
  Keys keys(json, of);
  keys.take("name");
  settings.method = keys.text("method", settings.method);
  const Json* coding = keys.take("coding");
  if (coding && !coding->is_null())
    settings.coding =
        keys.word("coding", Coding::Deflate, {Coding::Rle16, Coding::Deflate, Coding::Adaptive});
  settings.weighting = keys.word("weighting", settings.weighting, kWeightings);
  if (const Json* target = keys.take("target")) settings.target = target_from(*target, of);
  if (const Json* seed = keys.take("seed")) settings.seed = seed_from(*seed, keys);
  const Json* correction = keys.take("ik");
  if (correction && !correction->is_null()) settings.correction = correction_from(*correction, of);
  settings.effort =
      keys.word("effort", settings.effort, {Effort::Draft, Effort::Default, Effort::Best});
  settings.ends = keys.word("ends", settings.ends, {Ends::Free, Ends::Even, Ends::Exact});
  if (const Json* loop = keys.take("loop"); loop && !loop->is_null())
    settings.loop = keys.word("loop", Loop::None, {Loop::None, Loop::Repeats, Loop::Follows});
  settings.track_error = keys.number("track_error", settings.track_error);
  if (const Json* importance = keys.take("importance"))
    settings.importance = importance_from(*importance, keys);
  if (const Json* promises = keys.take("promises"))
    settings.promises = promises_from(*promises, of);
  if (const Json* limits = keys.take("limits")) settings.limits = limits_from(*limits, of);
  if (const Json* contacts = keys.take(kContacts))
    settings.contacts = contacts_from(*contacts, keys, of);
  if (const Json* ranges = keys.take(kRanges)) settings.ranges = ranges_from(*ranges, keys, of);
  keys.end();
  return settings;
}

}  // namespace

Json to_json(const Settings& settings) {
  Json json = {{"name", settings.name},
               {"method", settings.method},
               {"coding", settings.coding ? Json(name(*settings.coding)) : Json()},
               {"weighting", name(settings.weighting)},
               {"target", {{"kind", name(settings.target.kind)}, {"value", settings.target.value}}},
               {"seed", settings.seed},
               {"ik", settings.correction ? to_json(*settings.correction) : Json()}};
  if (settings.effort != Effort::Default) json["effort"] = name(settings.effort);
  if (!settings.importance.is_even()) json["importance"] = to_json(settings.importance);
  if (settings.promises.any()) json["promises"] = to_json(settings.promises);
  if (settings.limits != SightLimits()) json["limits"] = to_json(settings.limits, false);
  if (settings.ends != Ends::Even) json["ends"] = name(settings.ends);
  if (settings.loop) json["loop"] = name(*settings.loop);
  if (settings.track_error != kUsualTrackError) json["track_error"] = settings.track_error;
  if (settings.contacts) json[kContacts] = to_json(*settings.contacts);
  if (!settings.ranges.empty()) json[kRanges] = to_json(settings.ranges);
  return json;
}

Settings settings_from(const Json& json) {
  Settings settings = read_settings(json);
  check(settings);
  return settings;
}

Json row_json(const Settings& settings) {
  const std::optional<Coding> coding = coding_of(settings);
  Json ratio;
  if (settings.correction)
    ratio = settings.correction->ratio ? Json(*settings.correction->ratio) : Json(kFound);
  return {{"method", settings.method},
          {"target", name(settings.target.kind)},
          {"target_value", settings.target.value},
          {"weighting", name(settings.weighting)},
          {"coding", coding ? Json(name(*coding)) : Json()},
          {"seed", settings.seed},
          {"ik_ratio", ratio}};
}

Settings settings_of_row(const Json& row) {
  Json json;
  for (const char* key : {"method", "weighting", "coding", "seed"}) json[key] = row.at(key);
  json["target"] = {{"kind", row.at("target")}, {"value", row.at("target_value")}};
  if (!row.at("ik_ratio").is_null()) json["ik"] = {{"ratio", row.at("ik_ratio")}};
  return read_settings(json);
}

Settings preset_from(const Json& json) {
  Settings preset = settings_from(json);
  if (preset.name.empty()) throw Error("a preset has no \"name\"");
  return preset;
}

std::string settings_to_json(const Settings& settings) {
  return dumped(to_json(settings));
}

Settings settings_from_json(const std::string& text) {
  const Json json = parse_json("settings", text);
  try {
    return settings_from(json);
  } catch (const Error& error) {
    constexpr std::string_view kPrefix = "settings: ";  // InputError writes it again
    std::string_view why = error.what();
    if (why.starts_with(kPrefix)) why.remove_prefix(kPrefix.size());
    throw InputError("settings", 0, 0, std::string(why));
  }
}

std::string presets_text(std::span<const Settings> presets) {
  Json all = Json::array();
  for (const Settings& preset : presets) all.push_back(to_json(preset));
  return dumped(presets.size() == 1 ? all.front() : all, 2) + '\n';
}

std::vector<Settings> parse_presets(const std::string& file, const std::string& text) {
  const Json json = parse_json(file, text);
  try {
    if (!json.is_array()) return {preset_from(json)};
    std::vector<Settings> presets;
    for (const Json& one : json) presets.push_back(preset_from(one));
    if (presets.empty()) throw Error("holds no preset");
    return presets;
  } catch (const InputError&) {
    throw;
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
}

Settings find_preset(const std::string& name_or_file) {
  std::string known;
  for (const Settings& preset : built_in_presets()) {
    if (slug(preset.name) == slug(name_or_file)) return preset;
    known += ", " + slug(preset.name);
  }
  if (!is_there(utf8_path(name_or_file)))
    throw InputError(name_or_file, 0, 0, "is neither a file nor a preset" + known);
  return parse_presets(name_or_file, read_text(utf8_path(name_or_file))).front();
}

}  // namespace mocapress
