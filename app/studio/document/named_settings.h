// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <optional>

#include "app/studio/document/document.h"
#include "core/base/json_text.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// The initial settings of a clip: "Gameplay".
const Settings& usualPreset();
ClipSettings usualSettings(const Skeleton& skeleton = {});

/// The settings with joints by name, for use on other clips. Edited contacts and ranges are left
/// out.
Settings presetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// Like presetOf(), but with the edited contacts and ranges; for use on this clip only.
Settings ownPresetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// Replaces the settings by a preset's. Contacts, ranges and loop stay unless the preset has its
/// own. Throws Error if the preset names a joint that the skeleton lacks.
ClipSettings withPreset(const ClipSettings& settings, const Settings& preset,
                        const Skeleton& skeleton);

/// True if the preset would change nothing.
bool isAsPreset(const ClipSettings& settings, const Settings& preset, const Skeleton& skeleton);

/// True if the studio can edit clips with this preset: its method is a wavelet method, and the
/// studio has its target.
bool isTunable(const Settings& preset);

/// A clip's settings as a project keeps them. Joints have names, so that the settings can be read
/// before the clip and survive a change of its file.
struct NamedSettings {
  Settings preset;  // named after the preset they came from; empty: none
  ContactSettings contacts;
};

NamedSettings namedSettings(const ClipSettings& settings, const Skeleton& skeleton);

/// Removes settings for things that the clip lacks, since its file may have changed.
NamedSettings fitting(NamedSettings settings, const Motion& motion);

/// Converts settings for use on the motion, without those that do not fit it.
ClipSettings settingsFor(const NamedSettings& settings, const Motion& motion);

/// Writes settings in the form of a preset file, with "contact_settings" added if they are not the
/// default.
Json toJson(const NamedSettings& settings);

/// Missing keys get defaults. Throws Error that names the wrong key.
NamedSettings namedSettingsFrom(Json json);

/// A pinned result as it is stored: its settings, not its bytes.
struct Pin {
  QString name;
  QColor colour;
  NamedSettings settings;
};

/// A clip of the library with its settings.
struct TunedClip {
  QString path;
  QString skeleton;                       // for an .amc; empty: the one beside the clip
  std::optional<NamedSettings> settings;  // unset: no settings of its own
  ReadOptions reading = {};               // import options
};

}  // namespace mocapress
