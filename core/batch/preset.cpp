// SPDX-License-Identifier: MIT
#include "core/batch/preset.h"

#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/compare/comparison_method.h"
#include "core/compare/contender.h"
#include "core/study/markup.h"

namespace mocapress {
namespace {

bool is_closed_loop(const Preset& preset) {
  return preset.method == name(Method::ClosedLoop);
}

}  // namespace

std::span<const Preset> built_in_presets() {
  // A hard maximum where someone looks closely; eps_x, which allows single frames more, elsewhere.
  static const std::vector<Preset> presets = {
      {.name = "Hero close-up", .target = {Target::Kind::MaxError, 0.5}},
      {.name = "Gameplay", .target = {Target::Kind::Error, 0.5}},
      {.name = "Crowd", .target = {Target::Kind::Error, 2}},
      {.name = "Archive", .target = {Target::Kind::MaxError, 0.1}}};
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
  if (!find_contender(preset.method)) refuse("has no method that is known: " + preset.method);
  const bool of_wavelets = find_comparison_method(preset.method) == nullptr;
  if (is_closed_loop(preset) && preset.coding.value_or(Coding::Adaptive) != Coding::Adaptive)
    refuse("wants a coding that the closed loop, which is coded adaptively, does not have");
  if (!std::isfinite(preset.target.value) || preset.target.value <= 0)
    refuse("has a target that is not above 0");
  if (!of_wavelets && preset.target.kind == Target::Kind::CoefficientRatio)
    refuse("has a coefficient ratio, which is a target for wavelets only");
  if (!preset.correction) return;
  if (!of_wavelets) refuse("has an IK correction, which corrects wavelets only");
  const double ratio = preset.correction->ratio.value_or(1);
  if (!std::isfinite(ratio) || ratio <= 0) refuse("has an IK ratio that is not above 0");
}

EncodeOptions encode_options(const Preset& preset, const Skeleton& skeleton) {
  EncodeOptions options{.coding = coding_of(preset).value_or(Coding::Deflate),
                        .weighting = preset.weighting,
                        .target = preset.target,
                        .seed = preset.seed};
  if (const Contender* contender = find_contender(preset.method))
    choose_wavelets(*contender, options);
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
      return plain(target.value) + ":1";
    case Target::Kind::CoefficientRatio:
      return "r = " + plain(target.value);
    case Target::Kind::Size:
      return plain(target.value) + " bytes";
    case Target::Kind::Error:
      return "eps_x " + plain(target.value) + " cm";
    case Target::Kind::MaxError:
      return "max " + plain(target.value) + " cm";
  }
  return "";
}

}  // namespace mocapress
