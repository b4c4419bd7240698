// SPDX-License-Identifier: MIT
// Presets as files: one JSON object, or an array of them.
//   {"name": "Mine", "method": "closed-loop", "coding": null, "weighting": "bone-ends",
//    "target": {"kind": "error", "value": 0.5}, "seed": 1,
//    "ik": {"ratio": "auto", "effectors": [], "solver": "nearest-pose", "at": "every-frame"},
//    "effort": "best", "importance": {"feet": 4, "lwrist": 2, "contacts": 20},
//    "contacts": [{"joint": "lfoot", "first_frame": 10, "last_frame": 25}]}
// Only the name must be there; what is left out is as in Preset{}. "ik": null is none. Contacts are
// of one clip, as the studio writes them for those that were edited.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/batch/preset.h"

namespace mocapress {

nlohmann::ordered_json to_json(const Preset& preset);

/// Throws Error, which says what is wrong with which key.
Preset preset_from(const nlohmann::ordered_json& json);

/// A file's text.
std::string presets_text(std::span<const Preset> presets);

/// Its presets. Throws InputError, with line and column where it is no JSON.
std::vector<Preset> parse_presets(const std::string& file, const std::string& text);

/// A built-in one by its name or slug(), else the first of a file. Throws InputError.
Preset find_preset(const std::string& name_or_file);

/// The text as JSON. Throws InputError with line and column.
nlohmann::ordered_json parse_json(const std::string& file, const std::string& text);

/// On one line; bytes that are not UTF-8, as file names may have, are replaced.
std::string dumped(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace mocapress
