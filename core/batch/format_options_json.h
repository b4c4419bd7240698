// SPDX-License-Identifier: MIT
#pragma once
// How files are read and written, as JSON: {"rate_hz": 60, "cm_per_unit": 2.54, "up": "z",
// "bvh_root": "add", "character": "HERO.glb"}. What is not set is left out.

#include <string>

#include "core/formats/motion_file.h"
#include "core/report/json_value.h"

namespace mocapress {

/// Puts what is set into an object, under keys that begin with `prefix`.
void put(Json& json, const ReadOptions& options, const std::string& prefix = {});

/// The inverse. Throws Error on a word that is not known, and like the JSON library does.
ReadOptions format_options(const Json& json, const std::string& prefix = {});

}  // namespace mocapress
