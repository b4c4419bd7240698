// SPDX-License-Identifier: MIT
// Limits as JSON:
//   {"distance_m": 5, "velocity": {"least": 2.4, "share": 0.07}, "slide": {"least": 1.05} ...}
#pragma once

#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// All limits, or those that differ from the built-in ones.
Json to_json(const SightLimits& limits, bool all);

/// The inverse; limits that are left out have the built-in value, and the distance `distance_m`.
/// Throws Error for an unknown key and for a limit that is not above 0.
SightLimits limits_from(const Json& json, double distance_m = kUsualDistance);

/// A file of a viewer's limits, and back. It is written without a distance, which presets and users
/// choose, but may have one. Throws InputError, which names `file`.
std::string limits_to_text(const SightLimits& limits);
SightLimits limits_from_text(const std::string& file, std::string_view text,
                             double distance_m = kUsualDistance);

}  // namespace mocapress
