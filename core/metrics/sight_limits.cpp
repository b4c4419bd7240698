// SPDX-License-Identifier: MIT
#include "core/metrics/sight_limits.h"

#include "core/base/names_all.h"
#include "core/base/number_text.h"

namespace mocapress {

std::string_view name(Cue cue) {
  constexpr std::string_view kNames[] = {"velocity", "place",  "jitter", "slide", "lift",
                                         "floor",    "flight", "head",   "hand"};
  static_assert(names_all<Cue>(kNames));
  return kNames[static_cast<std::size_t>(cue)];
}

std::string_view unit(Cue cue) {
  switch (cue) {
    case Cue::Velocity:
    case Cue::Flight:
      return "cm/s";
    case Cue::Head:
    case Cue::Hand:
      return "degrees";
    default:
      return "cm";
  }
}

std::string limits_text(const SightLimits& limits) {
  const SightLimits built_in;
  std::string own;
  for (std::size_t c = 0; c < kCues; ++c) {
    const auto cue = static_cast<Cue>(c);
    const CueLimit& limit = limits.of(cue);
    if (limit == built_in.of(cue)) continue;
    own += (own.empty() ? "own limits: " : ", ") + std::string(name(cue)) + ' ' +
           significant_text(limit.least, 3) + ' ' + std::string(unit(cue));
    if (limit.share > 0) own += " or " + significant_text(100 * limit.share, 3) + " %";
  }
  return own.empty() ? "built-in limits" : own;
}

}  // namespace mocapress
