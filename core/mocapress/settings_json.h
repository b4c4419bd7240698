// SPDX-License-Identifier: MIT
// Settings as JSON values: the form is that of settings_to_json(). A file of presets has one such
// object, or an array of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/json_text.h"
#include "core/mocapress/settings.h"

namespace mocapress {

Json to_json(const Settings& settings);

/// Throws Error, which names the key and what is wrong with it.
Settings settings_from(const Json& json);

/// The same for settings that must have a name.
Settings preset_from(const Json& json);

/// The settings as flat keys of a row of results: "method", "target", "target_value", "weighting",
/// "coding", "seed", "ik_ratio" (null: no correction).
Json row_json(const Settings& settings);

/// The inverse. Throws Error, or like the JSON library does.
Settings settings_of_row(const Json& row);

/// The text of a file of presets.
std::string presets_text(std::span<const Settings> presets);

/// The presets of such a file. Throws InputError, with line and column if it is no JSON.
std::vector<Settings> parse_presets(const std::string& file, const std::string& text);

}  // namespace mocapress
