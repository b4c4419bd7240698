// SPDX-License-Identifier: MIT
#include "core/batch/preset.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/baselines/comparison_method.h"
#include "core/baselines/compression_method.h"
#include "core/report/markup.h"

namespace mocapress {
namespace {

bool is_closed_loop(const Preset& preset) {
  return preset.method == name(Method::ClosedLoop);
}

std::vector<ContactSpan> contacts_for(const std::vector<PresetContact>& contacts,
                                      const Skeleton& skeleton) {
  const std::vector<Landmark> points = landmarks(skeleton);
  std::vector<ContactSpan> spans;
  for (const PresetContact& contact : contacts) {
    const auto point = std::find_if(points.begin(), points.end(),
                                    [&](const Landmark& one) { return one.name == contact.point; });
    if (point == points.end()) throw Error("the skeleton has no joint named " + contact.point);
    spans.push_back(
        {static_cast<int>(point - points.begin()), contact.first_frame, contact.last_frame});
  }
  return spans;
}

}  // namespace

std::span<const Preset> built_in_presets() {
  // Heads and hands are looked at more than they have skin, and feet stand. With these factors no
  // head of the corpus is turned by more than 2.5 degrees at gameplay, no hand by more than 4 (RMS
  // over a clip), close up by a third, in a crowd by three times of that.
  const NamedImportance looks{.factors = {{"feet", 4}, {"fingers", 8}, {"hands", 54}, {"head", 3}},
                              .contacts = 0};
  NamedImportance planted = looks;
  planted.contacts = 20;
  constexpr Weighting kSkin = Weighting::Surface;
  static const std::vector<Preset> presets = {
      {.name = "Hero close-up",
       .weighting = kSkin,
       .target = {Target::Kind::Error, 0.065},
       .importance = looks},
      {.name = "Gameplay",
       .weighting = kSkin,
       .target = {Target::Kind::Error, 0.25},
       .importance = looks},
      // On 02_01, 16_22, 49_02 and 14_06 none to three fifths of the sliding are left, for 5 to 13
      // % more bytes.
      {.name = "Planted feet",
       .weighting = kSkin,
       .target = {Target::Kind::Error, 0.25},
       .importance = planted},
      {.name = "Crowd",
       .weighting = kSkin,
       .target = {Target::Kind::Error, 0.6},
       .importance = looks},
      {.name = "Archive", .weighting = kSkin, .target = {Target::Kind::MaxError, 0.1}}};
  return presets;
}

std::string slug(std::string_view name) {
  std::string word;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) || letter >= 0x80 || c == '.' || c == '_')
      word += static_cast<char>(std::tolower(letter));
    else if (!word.empty() && word.back() != '-')
      word += '-';
  }
  while (!word.empty() && word.back() == '-') word.pop_back();
  return word;
}

std::optional<Coding> coding_of(const Preset& preset) {
  if (find_comparison_method(preset.method)) return std::nullopt;
  return is_closed_loop(preset) ? Coding::Adaptive : preset.coding.value_or(Coding::Deflate);
}

void check(const Preset& preset) {
  const auto refuse = [&](const std::string& why) {
    throw Error("the preset \"" + preset.name + "\" " + why);
  };
  if (!find_compression_method(preset.method)) refuse("has an unknown method: " + preset.method);
  const bool of_wavelets = find_comparison_method(preset.method) == nullptr;
  if (is_closed_loop(preset) && preset.coding.value_or(Coding::Adaptive) != Coding::Adaptive)
    refuse("has a coding other than adaptive, the only one of the closed loop");
  if (!std::isfinite(preset.target.value) || preset.target.value <= 0)
    refuse("has a target that is not above 0");
  if (!of_wavelets && preset.target.kind == Target::Kind::CoefficientRatio)
    refuse("has a coefficient ratio, a target of wavelet methods only");
  if (preset.effort == Effort::Draft)
    refuse("has the effort draft, which does not promise its target");
  const auto check_factor = [&](double factor, const std::string& of) {
    if (!std::isfinite(factor) || factor < 0)
      refuse("has an importance of " + of + " that is not a number of 0 or more");
  };
  check_factor(preset.importance.contacts, "contacts");
  for (const auto& [name, factor] : preset.importance.factors) check_factor(factor, name);
  if (!preset.correction) return;
  if (!of_wavelets) refuse("has an IK correction, which can correct wavelet methods only");
  const double ratio = preset.correction->ratio.value_or(1);
  if (!std::isfinite(ratio) || ratio <= 0) refuse("has an IK ratio that is not above 0");
}

EncodeOptions encode_options(const Preset& preset, const Skeleton& skeleton) {
  EncodeOptions options{.coding = coding_of(preset).value_or(Coding::Deflate),
                        .weighting = preset.weighting,
                        .target = preset.target,
                        .seed = preset.seed,
                        .effort = preset.effort,
                        .importance = importance_for(preset.importance, skeleton),
                        .ends = preset.ends,
                        .loop = preset.loop};
  if (const CompressionMethod* compression_method = find_compression_method(preset.method))
    choose_wavelets(*compression_method, options);
  if (preset.contacts) options.contacts = contacts_for(*preset.contacts, skeleton);
  if (!preset.correction) return options;
  const PresetCorrection& wanted = *preset.correction;
  options.correction =
      CorrectionOptions{.ratio = wanted.ratio, .solver = wanted.solver, .at = wanted.at};
  for (const std::string& effector : wanted.effectors) {
    const int joint = skeleton.find(effector);
    if (joint < 0) throw Error("the skeleton has no joint named " + effector);
    options.correction->joints.push_back(joint);
  }
  return options;
}

std::string target_text(const Target& target) {
  switch (target.kind) {
    case Target::Kind::Ratio:
      return format_shortest(target.value) + ":1";
    case Target::Kind::CoefficientRatio:
      return "r = " + format_shortest(target.value);
    case Target::Kind::Size:
      return format_shortest(target.value) + " bytes";
    case Target::Kind::Error:
      return "eps_x " + format_shortest(target.value) + " cm";
    case Target::Kind::MaxError:
      return "max " + format_shortest(target.value) + " cm";
    case Target::Kind::Visibility:
      return target.value == 1 ? "not visible" : format_shortest(target.value) + " times noticed";
  }
  return "";
}

}  // namespace mocapress
