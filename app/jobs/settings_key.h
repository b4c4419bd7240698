// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mocapress {

struct EncodeOptions;

/// Equal for settings that give the same bytes and measures of the same clip.
std::string settingsKey(const EncodeOptions& options);

}  // namespace mocapress
