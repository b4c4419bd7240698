// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/target.h"

#include <array>
#include <cmath>
#include <utility>

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

}  // namespace

std::string_view name(Target::Kind kind) {
  for (const auto& [value, word] : kKinds)
    if (value == kind) return word;
  return "";
}

std::optional<Target::Kind> target_kind(std::string_view name) {
  for (const auto& [value, word] : kKinds)
    if (word == name) return value;
  return std::nullopt;
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

}  // namespace mocapress
