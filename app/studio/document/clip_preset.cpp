// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/clip_preset.h"

#include "app/jobs/settings_key.h"
#include "core/base/error.h"
#include "core/baselines/compression_method.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

/// The method of compression_methods() that is that one in that basis.
std::string contenderOf(const EncodeOptions& options) {
  for (const CompressionMethod& compression_method : compression_methods()) {
    EncodeOptions chosen;
    if (choose_wavelets(compression_method, chosen) && chosen.method == options.method &&
        chosen.basis == options.basis)
      return std::string(compression_method.name);
  }
  return std::string(name(options.method));
}

PresetCorrection presetOf(const CorrectionOptions& correction, const Skeleton& skeleton) {
  PresetCorrection preset{
      .ratio = correction.ratio, .effectors = {}, .solver = correction.solver, .at = correction.at};
  for (const int joint : correction.joints) preset.effectors.push_back(skeleton.joint(joint).name);
  return preset;
}

}  // namespace

const Preset& usualPreset() {
  return built_in_presets()[1];
}

ClipSettings usualSettings(const Skeleton& skeleton) {
  const Preset& usual = usualPreset();
  return {encode_options(usual, skeleton), {}, QString::fromStdString(usual.name)};
}

Preset presetOf(const ClipSettings& settings, const Skeleton& skeleton) {
  const EncodeOptions& options = settings.encode;
  Preset preset{.name = settings.preset.toStdString(),
                .method = contenderOf(options),
                .coding = {},
                .weighting = options.weighting,
                .target = options.target,
                .seed = options.seed,
                .effort = options.effort,
                .importance = named(options.importance, skeleton),
                .ends = options.ends,
                .loop = options.loop,
                .correction = {},
                .contacts = {}};
  if (effective_coding(options) != coding_of(preset)) preset.coding = options.coding;
  if (options.correction) preset.correction = presetOf(*options.correction, skeleton);
  return preset;
}

Preset ownPresetOf(const ClipSettings& settings, const Skeleton& skeleton) {
  Preset preset = presetOf(settings, skeleton);
  if (!settings.encode.contacts) return preset;
  const std::vector<Landmark> points = landmarks(skeleton);
  preset.contacts.emplace();
  for (const ContactSpan& span : *settings.encode.contacts)
    preset.contacts->push_back(
        {points[static_cast<std::size_t>(span.landmark)].name, span.first_frame, span.last_frame});
  return preset;
}

ClipSettings withPreset(const ClipSettings& settings, const Preset& preset,
                        const Skeleton& skeleton) {
  ClipSettings with = settings;
  with.encode = encode_options(preset, skeleton);
  if (!with.encode.contacts) with.encode.contacts = settings.encode.contacts;
  with.preset = QString::fromStdString(preset.name);
  return with;
}

bool isAsPreset(const ClipSettings& settings, const Preset& preset, const Skeleton& skeleton) {
  try {
    return settingsKey(withPreset(settings, preset, skeleton).encode) ==
           settingsKey(settings.encode);
  } catch (const Error&) {
    return false;
  }
}

bool isTunable(const Preset& preset) {
  EncodeOptions options;
  const CompressionMethod* compression_method = find_compression_method(preset.method);
  return compression_method && choose_wavelets(*compression_method, options) &&
         preset.target.kind != Target::Kind::CoefficientRatio;
}

}  // namespace mocapress
