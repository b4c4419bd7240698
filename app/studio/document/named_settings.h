// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/studio/document/document.h"
#include "core/batch/preset.h"

namespace mocapress {

/// A clip's settings as a project keeps them: joints by their names, so that they can be read
/// before the clip is, and stand when its file is another.
struct NamedSettings {
  Preset preset;  // has the name of the preset they come of; empty: of none
  ContactSettings contacts;
};

NamedSettings namedSettings(const ClipSettings& settings, const Skeleton& skeleton);

/// Without what a clip does not have: its file may be another than when the settings were kept.
NamedSettings fitting(NamedSettings settings, const Motion& motion);

/// Those that fit.
ClipSettings settingsFor(const NamedSettings& settings, const Motion& motion);

/// The form of a preset file, with "contact_settings" beside its keys where they are not as usual.
nlohmann::ordered_json toJson(const NamedSettings& settings);

/// What is left out is as usual. Throws Error, which says what is wrong with which key.
NamedSettings namedSettingsFrom(nlohmann::ordered_json json);

}  // namespace mocapress
