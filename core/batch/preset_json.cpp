// SPDX-License-Identifier: MIT
#include "core/batch/preset_json.h"

#include <algorithm>
#include <climits>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFound = "auto";
constexpr const char* kContacts = "contacts";  // among the names of importance

/// The keys of one object, each taken once; what is left over is a mistake.
class Keys {
 public:
  Keys(const Json& json, std::string of) : json_(json), of_(std::move(of)) {
    if (!json.is_object()) throw Error(of_ + " is not a JSON object");
  }

  /// nullptr when it is not there.
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

  /// -1 when it is not there.
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
      if (std::find(taken_.begin(), taken_.end(), key) == taken_.end())
        throw Error(of_ + ": \"" + key + "\" is unknown");
  }

 private:
  const Json& json_;
  std::string of_;
  std::vector<std::string> taken_;
};

Json to_json(const PresetCorrection& correction) {
  return {{"ratio", correction.ratio ? Json(*correction.ratio) : Json(kFound)},
          {"effectors", correction.effectors},
          {"solver", name(correction.solver)},
          {"at", name(correction.at)}};
}

PresetCorrection correction_from(const Json& json, const std::string& of) {
  Keys keys(json, of + ": \"ik\"");
  PresetCorrection correction;
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

Json to_json(const std::vector<PresetContact>& contacts) {
  Json json = Json::array();
  for (const PresetContact& contact : contacts)
    json.push_back({{"joint", contact.point},
                    {"first_frame", contact.first_frame},
                    {"last_frame", contact.last_frame}});
  return json;
}

std::vector<PresetContact> contacts_from(const Json& json, const Keys& keys,
                                         const std::string& of) {
  std::vector<PresetContact> contacts;
  if (!json.is_array()) keys.refuse(kContacts, "is not a list of contacts");
  for (const Json& one : json) {
    Keys contact(one, of + ": a contact");
    PresetContact read{contact.text("joint", ""), contact.frame("first_frame"),
                       contact.frame("last_frame")};
    contact.end();
    if (read.point.empty() || read.first_frame < 0 || read.last_frame < read.first_frame)
      keys.refuse(kContacts, "is not a list of joints with a first and a last frame");
    contacts.push_back(std::move(read));
  }
  return contacts;
}

std::uint64_t seed_from(const Json& json, const Keys& keys) {
  if (!json.is_number_unsigned()) keys.refuse("seed", "is not a whole number");
  return json.get<std::uint64_t>();
}

}  // namespace

Json to_json(const Preset& preset) {
  Json json = {{"name", preset.name},
               {"method", preset.method},
               {"coding", preset.coding ? Json(name(*preset.coding)) : Json()},
               {"weighting", name(preset.weighting)},
               {"target", {{"kind", name(preset.target.kind)}, {"value", preset.target.value}}},
               {"seed", preset.seed},
               {"ik", preset.correction ? to_json(*preset.correction) : Json()}};
  if (preset.effort != Effort::Default) json["effort"] = name(preset.effort);
  if (!preset.importance.is_even()) json["importance"] = to_json(preset.importance);
  if (preset.ends != Ends::Even) json["ends"] = name(preset.ends);
  if (preset.loop) json["loop"] = name(*preset.loop);
  if (preset.contacts) json[kContacts] = to_json(*preset.contacts);
  return json;
}

Preset preset_from(const Json& json) {
  Preset preset;
  preset.name = Keys(json, "a preset").text("name", "");
  if (preset.name.empty()) throw Error("a preset has no \"name\"");
  const std::string of = "the preset \"" + preset.name + "\"";
  Keys keys(json, of);
  keys.take("name");
  preset.method = keys.text("method", preset.method);
  const Json* coding = keys.take("coding");
  if (coding && !coding->is_null())
    preset.coding =
        keys.word("coding", Coding::Deflate, {Coding::Rle16, Coding::Deflate, Coding::Adaptive});
  preset.weighting = keys.word("weighting", preset.weighting, kWeightings);
  if (const Json* target = keys.take("target")) preset.target = target_from(*target, of);
  if (const Json* seed = keys.take("seed")) preset.seed = seed_from(*seed, keys);
  const Json* correction = keys.take("ik");
  if (correction && !correction->is_null()) preset.correction = correction_from(*correction, of);
  preset.effort =
      keys.word("effort", preset.effort, {Effort::Draft, Effort::Default, Effort::Best});
  preset.ends = keys.word("ends", preset.ends, {Ends::Free, Ends::Even, Ends::Exact});
  if (const Json* loop = keys.take("loop"); loop && !loop->is_null())
    preset.loop = keys.word("loop", Loop::None, {Loop::None, Loop::Repeats, Loop::Follows});
  if (const Json* importance = keys.take("importance"))
    preset.importance = importance_from(*importance, keys);
  if (const Json* contacts = keys.take(kContacts))
    preset.contacts = contacts_from(*contacts, keys, of);
  keys.end();
  check(preset);
  return preset;
}

std::string presets_text(std::span<const Preset> presets) {
  Json all = Json::array();
  for (const Preset& preset : presets) all.push_back(to_json(preset));
  return dumped(presets.size() == 1 ? all.front() : all, 2) + '\n';
}

std::vector<Preset> parse_presets(const std::string& file, const std::string& text) {
  const Json json = parse_json(file, text);
  try {
    if (!json.is_array()) return {preset_from(json)};
    std::vector<Preset> presets;
    for (const Json& one : json) presets.push_back(preset_from(one));
    if (presets.empty()) throw Error("holds no preset");
    return presets;
  } catch (const InputError&) {
    throw;
  } catch (const Error& error) {
    throw InputError(file, 0, 0, error.what());
  }
}

Preset find_preset(const std::string& name_or_file) {
  std::string known;
  for (const Preset& preset : built_in_presets()) {
    if (slug(preset.name) == slug(name_or_file)) return preset;
    known += ", " + slug(preset.name);
  }
  std::error_code ignored;
  if (!std::filesystem::exists(name_or_file, ignored))
    throw InputError(name_or_file, 0, 0, "is neither a file nor a preset" + known);
  return parse_presets(name_or_file, read_text(name_or_file)).front();
}

Json parse_json(const std::string& file, const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::string_view before =
        std::string_view(text).substr(0, error.byte == 0 ? 0 : error.byte - 1);
    const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 when there is none
    throw InputError(file, line, static_cast<int>(before.size() - line_begin) + 1,
                     "is not JSON from here on");
  }
}

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mocapress
