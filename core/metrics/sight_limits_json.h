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

/// The inverse; what is left out has the built-in value. Throws Error for an unknown key and for a
/// limit that is not above 0.
SightLimits limits_from(const Json& json);

/// A file of limits, and back. Throws InputError, which names `file`.
std::string limits_to_text(const SightLimits& limits);
SightLimits limits_from_text(const std::string& file, std::string_view text);

}  // namespace mocapress
