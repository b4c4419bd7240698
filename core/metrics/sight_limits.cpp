// SPDX-License-Identifier: MIT
#include "core/metrics/sight_limits.h"

namespace mocapress {

std::string_view name(Cue cue) {
  constexpr std::string_view kNames[] = {"velocity", "place",  "jitter", "slide", "lift",
                                         "floor",    "flight", "head",   "hand"};
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

}  // namespace mocapress
