// SPDX-License-Identifier: MIT
#pragma once
// Options for reading and writing files, as JSON: {"rate_hz": 60, "cm_per_unit": 2.54, "up": "z",
// "bvh_root": "add", "character": "HERO.glb"}. Options that are not set are left out.

#include <string>

#include "core/formats/motion_file.h"
#include "core/report/json_value.h"

namespace mocapress {

/// Adds the options that are set to an object, under keys that start with `prefix`.
void put(Json& json, const ReadOptions& options, const std::string& prefix = {});

/// Reads what put() wrote. Throws Error for an unknown word, and the JSON library's exceptions.
ReadOptions format_options(const Json& json, const std::string& prefix = {});

}  // namespace mocapress
