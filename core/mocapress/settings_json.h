// SPDX-License-Identifier: MIT
// Settings as JSON values, in the form of settings_to_json(). A file of presets has one such
// object, or an array of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/json_text.h"
#include "core/mocapress/settings.h"

namespace mocapress {

Json to_json(const Settings& settings);

/// Reads settings. Throws Error, which names the key and what is wrong with it.
Settings settings_from(const Json& json);

/// Reads settings that must have a name.
Settings preset_from(const Json& json);

/// Settings as flat keys for a row of results: "method", "target", "target_value", "weighting",
/// "coding", "seed", "ik_ratio" (null: no correction).
Json row_json(const Settings& settings);

/// Reads what row_json() made. Throws Error and the JSON library's exceptions.
Settings settings_of_row(const Json& row);

/// Writes presets as the text of a file.
std::string presets_text(std::span<const Settings> presets);

/// Reads the presets of a file. Throws InputError, with line and column if the text is not JSON.
std::vector<Settings> parse_presets(const std::string& file, const std::string& text);

}  // namespace mocapress
