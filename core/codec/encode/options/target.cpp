// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/target.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"

namespace mocapress {
namespace {

constexpr std::array<std::pair<Target::Kind, std::string_view>, 6> kKinds = {{
    {Target::Kind::Ratio, "ratio"},
    {Target::Kind::CoefficientRatio, "coefficient-ratio"},
    {Target::Kind::Size, "size"},
    {Target::Kind::Error, "error"},
    {Target::Kind::MaxError, "max-error"},
    {Target::Kind::Visibility, "not-visible"},
}};

/// A value of the target's quantity with its unit.
std::string text_of(Target::Kind kind, double value) {
  const std::string number = significant_text(value, kind == Target::Kind::Size ? 12 : 4);
  switch (kind) {
    case Target::Kind::Ratio:
    case Target::Kind::CoefficientRatio:
      return number + ":1";
    case Target::Kind::Size:
      return number + " bytes";
    case Target::Kind::Error:
    case Target::Kind::MaxError:
      return number + " cm";
    case Target::Kind::Visibility:
      return number + " times what is noticed";
  }
  return number;
}

}  // namespace

std::string_view name(Target::Kind kind) {
  for (const auto& [value, word] : kKinds)
    if (value == kind) return word;
  return "";
}

bool reached(const Target& target, double achieved) {
  constexpr double kRatioTolerance = 0.02;
  constexpr double kRounding = 1e-9;
  switch (target.kind) {
    case Target::Kind::Ratio:
      return std::abs(achieved / target.value - 1) <= kRatioTolerance + kRounding;
    case Target::Kind::CoefficientRatio:
      return achieved > 0;
    default:
      return achieved <= target.value * (1 + kRounding);
  }
}

std::string out_of_reach(const Target& target, double nearest) {
  std::string text = "the target of " + text_of(target.kind, target.value) +
                     " is out of reach with this method: the nearest is " +
                     text_of(target.kind, nearest);
  if (target.kind == Target::Kind::Ratio)
    text += nearest > target.value ? ", a smaller file" : ", a larger file";
  return text;
}

}  // namespace mocapress
