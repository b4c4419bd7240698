// SPDX-License-Identifier: MIT
#include "core/mocapress/settings.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/methods/comparison_method.h"
#include "core/codec/methods/compression_method.h"
#include "core/report/markup.h"

namespace mocapress {
namespace {

bool is_closed_loop(const Settings& settings) {
  return settings.method == name(Method::ClosedLoop);
}

}  // namespace

std::span<const Settings> built_in_presets() {
  // People look at heads and hands more than their share of the surface suggests, and feet stand on
  // the ground. With these factors most clips keep the promises from the start; otherwise an encode
  // raises the factors.
  const NamedImportance looks{.factors = {{"feet", 4}, {"fingers", 8}, {"hands", 54}, {"head", 3}},
                              .contacts = 0};
  NamedImportance planted = looks;
  planted.contacts = 20;
  const auto promises = [](double times) {
    return Promises{.head_degrees = 2.5 * times,
                    .hand_degrees = 4 * times,
                    .finger_degrees = 6 * times,
                    .root_cm = 0.2 * times,
                    .root_degrees = 0.3 * times};
  };
  constexpr double kCloseUp = 1.0 / 3;
  constexpr double kCrowd = 3;
  // Seen from these distances, a person is 26, 7 and 2.6 cm tall on a screen 60 cm away. On the
  // study clips, errors of Gameplay are not visible from its distance, or borderline (FIGURES.md,
  // "What the eye sees").
  constexpr SightLimits kNearby{.distance_m = 4};
  constexpr SightLimits kInPlay{.distance_m = 15};
  constexpr SightLimits kInCrowds{.distance_m = 40};
  static const std::vector<Settings> presets = {
      {.name = "Hero close-up",
       .target = {Target::Kind::Error, 0.065},
       .importance = looks,
       .promises = promises(kCloseUp),
       .limits = kNearby},
      {.name = "Gameplay",
       .target = {Target::Kind::Error, 0.25},
       .importance = looks,
       .promises = promises(1),
       .limits = kInPlay},
      // On average over the study clips, a ninth of the sliding is left, for 9 % more bytes.
      {.name = "Planted feet",
       .target = {Target::Kind::Error, 0.25},
       .importance = planted,
       .promises = promises(1),
       .limits = kInPlay},
      {.name = "Crowd",
       .target = {Target::Kind::Error, 0.6},
       .importance = looks,
       .promises = promises(kCrowd),
       .limits = kInCrowds},
      {.name = "Archive",
       .target = {Target::Kind::MaxError, 0.1},
       .promises = promises(kCloseUp),
       .limits = kNearby}};
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

std::optional<Coding> coding_of(const Settings& settings) {
  if (find_comparison_method(settings.method)) return std::nullopt;
  return is_closed_loop(settings) ? Coding::Adaptive : settings.coding.value_or(Coding::Deflate);
}

void check(const Settings& settings) {
  const auto refuse = [&](const std::string& why) {
    throw Error(
        (settings.name.empty() ? "the compression " : "the preset \"" + settings.name + "\" ") +
        why);
  };
  if (!find_compression_method(settings.method))
    refuse("has an unknown method: " + settings.method);
  const bool of_wavelets = find_comparison_method(settings.method) == nullptr;
  if (is_closed_loop(settings) && settings.coding.value_or(Coding::Adaptive) != Coding::Adaptive)
    refuse("has a coding other than adaptive, the only one of the closed loop");
  if (!std::isfinite(settings.target.value) || settings.target.value <= 0)
    refuse("has a target that is not above 0");
  if (!of_wavelets && settings.target.kind == Target::Kind::CoefficientRatio)
    refuse("has a coefficient ratio, a target of wavelet methods only");
  if (!std::isfinite(settings.track_error) || settings.track_error <= 0)
    refuse("has a track error that is not above 0");
  for (const PromiseKey& promise : kPromiseKeys)
    if (const auto& bound = settings.promises.*promise.bound; bound && !(*bound > 0))
      refuse(std::string("has a promise that is not above 0: ") + promise.key);
  if (settings.effort == Effort::Draft)
    refuse("has the effort draft, which does not promise its target");
  const auto check_factor = [&](double factor, const std::string& of) {
    if (!std::isfinite(factor) || factor < 0)
      refuse("has an importance of " + of + " that is not a number of 0 or more");
  };
  check_factor(settings.importance.contacts, "contacts");
  for (const auto& [name, factor] : settings.importance.factors) check_factor(factor, name);
  for (const ImportantRange& range : settings.ranges)
    if (!(range.factor >= 1 && range.factor <= kMostRangeFactor))
      refuse("has an importance of frames that is not a number from 1 to " +
             format_shortest(kMostRangeFactor));
  if (!settings.correction) return;
  if (!of_wavelets) refuse("has an IK correction, which can correct wavelet methods only");
  const double ratio = settings.correction->ratio.value_or(1);
  if (!std::isfinite(ratio) || ratio <= 0) refuse("has an IK ratio that is not above 0");
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
