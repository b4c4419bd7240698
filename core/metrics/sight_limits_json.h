// SPDX-License-Identifier: MIT
// Limits as JSON:
//   {"distance_m": 5, "velocity": {"least": 2.4, "share": 0.07}, "slide": {"least": 1.05} ...}
#pragma once

#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/metrics/sight_limits.h"

namespace mocapress {

/// The limits as JSON: all of them, or only those that differ from the built-in ones.
Json to_json(const SightLimits& limits, bool all);

/// The limits from such JSON. Limits that are left out have the built-in value; a distance that is
/// left out is `distance_m`. Throws Error for an unknown key and for a limit that is not above 0.
SightLimits limits_from(const Json& json, double distance_m = kUsualDistance);

/// The text of a file of a viewer's limits, and the limits from such a text. It is written without
/// a distance, since presets and users choose that, but a text that is read may have one. Throws
/// InputError, which names `file`.
std::string limits_to_text(const SightLimits& limits);
SightLimits limits_from_text(const std::string& file, std::string_view text,
                             double distance_m = kUsualDistance);

}  // namespace mocapress
