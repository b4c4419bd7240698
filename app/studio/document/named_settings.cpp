// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/named_settings.h"

#include <algorithm>
#include <array>

#include "app/jobs/result_cache.h"
#include "app/studio/document/own_limits.h"
#include "core/base/error.h"
#include "core/codec/methods/compression_method.h"
#include "core/mocapress/encode_settings.h"
#include "core/mocapress/settings_json.h"
#include "core/motion/landmarks.h"
#include "core/report/json_value.h"

namespace mocapress {

namespace {

/// The name in compression_methods() of the method with the options' method and basis.
std::string methodOf(const EncodeSettings& options) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    EncodeSettings chosen;
    if (choose_wavelets(compression_method, chosen) && chosen.method == options.method &&
        chosen.basis == options.basis)
      return std::string(compression_method.name);
  }
  return std::string(name(options.method));
}

CorrectionSettings presetOf(const EncodeCorrection& correction, const Skeleton& skeleton) {
  CorrectionSettings preset{
      .ratio = correction.ratio, .effectors = {}, .solver = correction.solver, .at = correction.at};
  for (const int joint : correction.joints) preset.effectors.push_back(skeleton.joint(joint).name);
  return preset;
}

}  // namespace

const Settings& usualPreset() {
  return built_in_presets()[1];
}

ClipSettings usualSettings(const Skeleton& skeleton) {
  const Settings& usual = usualPreset();
  return {withOwnLimits(encode_settings(usual, skeleton)),
          {},
          QString::fromStdString(usual.name),
          usual.track_error};
}

Settings presetOf(const ClipSettings& settings, const Skeleton& skeleton) {
  const EncodeSettings& options = settings.encode;
  Settings preset{.name = settings.preset.toStdString(),
                  .method = methodOf(options),
                  .coding = {},
                  .weighting = options.weighting,
                  .target = options.target,
                  .seed = options.seed,
                  .effort = options.effort,
                  .importance = named(options.importance, skeleton),
                  .promises = options.promises,
                  .limits = options.limits,
                  .ends = options.ends,
                  .loop = options.loop,
                  .track_error = settings.track_error,
                  .correction = {},
                  .contacts = {}};
  if (effective_coding(options) != coding_of(preset)) preset.coding = options.coding;
  if (options.correction) preset.correction = presetOf(*options.correction, skeleton);
  return preset;
}

Settings ownPresetOf(const ClipSettings& settings, const Skeleton& skeleton) {
  Settings preset = presetOf(settings, skeleton);
  preset.ranges = settings.encode.ranges;
  if (!settings.encode.contacts) return preset;
  const std::vector<Landmark> points = landmarks(skeleton);
  preset.contacts.emplace();
  for (const ContactSpan& span : *settings.encode.contacts)
    preset.contacts->push_back(
        {points[static_cast<std::size_t>(span.landmark)].name, span.first_frame, span.last_frame});
  return preset;
}

ClipSettings withPreset(const ClipSettings& settings, const Settings& preset,
                        const Skeleton& skeleton) {
  ClipSettings with = settings;
  with.encode = withOwnLimits(encode_settings(preset, skeleton));
  if (!with.encode.contacts) with.encode.contacts = settings.encode.contacts;
  if (with.encode.ranges.empty()) with.encode.ranges = settings.encode.ranges;
  if (!with.encode.loop) with.encode.loop = settings.encode.loop;
  with.preset = QString::fromStdString(preset.name);
  with.track_error = preset.track_error;
  return with;
}

bool isAsPreset(const ClipSettings& settings, const Settings& preset, const Skeleton& skeleton) {
  try {
    return preset.track_error == settings.track_error &&
           settingsKey(withPreset(settings, preset, skeleton).encode) ==
               settingsKey(settings.encode);
  } catch (const Error&) {
    return false;
  }
}

bool isTunable(const Settings& preset) {
  EncodeSettings options;
  const CompressionMethod* compression_method = find_compression_method(preset.method);
  return compression_method && choose_wavelets(*compression_method, options) &&
         preset.target.kind != Target::Kind::CoefficientRatio;
}

namespace {

constexpr const char* kName = "name";
constexpr const char* kContactSettings = "contact_settings";
constexpr const char* kNone = "none";  // name in the file, which needs one

struct ContactKey {
  const char* key;
  double ContactSettings::*value;
};

constexpr std::array kContactKeys = {ContactKey{"begin_height_cm", &ContactSettings::begin_height},
                                     ContactKey{"end_height_cm", &ContactSettings::end_height},
                                     ContactKey{"begin_speed_cm_s", &ContactSettings::begin_speed},
                                     ContactKey{"end_speed_cm_s", &ContactSettings::end_speed},
                                     ContactKey{"least_seconds", &ContactSettings::least_seconds}};

ContactSettings contactSettingsFrom(const Json& json) {
  ContactSettings settings;
  if (!json.is_object()) throw Error("\"contact_settings\" is not a JSON object");
  for (const auto& [key, member] : kContactKeys) {
    const auto found = json.find(key);
    if (found == json.end()) continue;
    if (!found->is_number()) throw Error(std::string("\"") + key + "\" is not a number");
    settings.*member = found->get<double>();
  }
  return settings;
}

}  // namespace

NamedSettings namedSettings(const ClipSettings& settings, const Skeleton& skeleton) {
  return {ownPresetOf(settings, skeleton), settings.contacts};
}

NamedSettings fitting(NamedSettings settings, const Motion& motion) {
  const Skeleton& skeleton = motion.skeleton;
  Settings& preset = settings.preset;
  const auto has_joint = [&](const std::string& joint) { return skeleton.find(joint) >= 0; };
  if (preset.correction)
    std::erase_if(preset.correction->effectors,
                  [&](const std::string& effector) { return !has_joint(effector); });
  std::erase_if(preset.importance.factors, [&](const auto& factor) {
    return !is_body_part(factor.first) && !has_joint(factor.first);
  });
  if (preset.contacts) {
    const std::vector<Landmark> points = landmarks(skeleton);
    std::erase_if(*preset.contacts, [&](const ContactSetting& contact) {
      return contact.first_frame < 0 || contact.last_frame < contact.first_frame ||
             contact.last_frame >= motion.clip.frames() ||
             std::none_of(points.begin(), points.end(),
                          [&](const Landmark& point) { return point.name == contact.point; });
    });
  }
  std::erase_if(preset.ranges, [&](const ImportantRange& range) {
    return range.last_frame >= motion.clip.frames();
  });
  if (preset.weighting == Weighting::Skin && !skeleton.skin())
    preset.weighting = Settings().weighting;
  if (preset.target.kind == Target::Kind::CoefficientRatio) preset.target = {};
  return settings;
}

ClipSettings settingsFor(const NamedSettings& settings, const Motion& motion) {
  const NamedSettings fit = fitting(settings, motion);
  return {withOwnLimits(encode_settings(fit.preset, motion.skeleton)), fit.contacts,
          QString::fromStdString(fit.preset.name), fit.preset.track_error};
}

Json toJson(const NamedSettings& settings) {
  Json json = to_json(settings.preset);
  if (settings.preset.name.empty()) json.erase(kName);
  if (settings.contacts != ContactSettings())
    for (const auto& [key, member] : kContactKeys)
      json[kContactSettings][key] = settings.contacts.*member;
  return json;
}

NamedSettings namedSettingsFrom(Json json) {
  if (!json.is_object()) throw Error("settings are not a JSON object");
  NamedSettings settings;
  if (json.contains(kContactSettings))
    settings.contacts = contactSettingsFrom(json[kContactSettings]);
  json.erase(kContactSettings);
  const bool has_name = json.contains(kName);
  if (!has_name) json[kName] = kNone;
  settings.preset = preset_from(json);
  if (!has_name) settings.preset.name.clear();
  return settings;
}

}  // namespace mocapress
