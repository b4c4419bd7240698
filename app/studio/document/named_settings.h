// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <optional>

#include "app/studio/document/document.h"
#include "core/base/json_text.h"
#include "core/mocapress/settings.h"

namespace mocapress {

/// What a clip begins with where nothing else is known of it: "Gameplay".
const Settings& usualPreset();
ClipSettings usualSettings(const Skeleton& skeleton = {});

/// The settings by names, so that other clips can take them. Edited contacts are left out.
Settings presetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// With the edited contacts: for this clip alone.
Settings ownPresetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// The settings as a preset has them; contacts stay. Throws Error where it names a joint that the
/// skeleton lacks.
ClipSettings withPreset(const ClipSettings& settings, const Settings& preset,
                        const Skeleton& skeleton);

/// Whether the preset would change nothing.
bool isAsPreset(const ClipSettings& settings, const Settings& preset, const Skeleton& skeleton);

/// Whether clips can be tuned by it, and not only measured: wavelets, by a target of the studio.
bool isTunable(const Settings& preset);

/// A clip's settings as a project keeps them: joints by their names, so that they can be read
/// before the clip is, and stand when its file is another.
struct NamedSettings {
  Settings preset;  // has the name of the preset they come of; empty: of none
  ContactSettings contacts;
};

NamedSettings namedSettings(const ClipSettings& settings, const Skeleton& skeleton);

/// Without what a clip does not have: its file may be another than when the settings were kept.
NamedSettings fitting(NamedSettings settings, const Motion& motion);

/// Those that fit.
ClipSettings settingsFor(const NamedSettings& settings, const Motion& motion);

/// The form of a preset file, with "contact_settings" beside its keys where they are not as usual.
Json toJson(const NamedSettings& settings);

/// What is left out is as usual. Throws Error, which says what is wrong with which key.
NamedSettings namedSettingsFrom(Json json);

/// A pinned result, as it is kept: by what it is made, not what was made.
struct Pin {
  QString name;
  QColor colour;
  NamedSettings settings;
};

/// A clip of the library, and what was decided about it.
struct TunedClip {
  QString path;
  QString skeleton;                       // for an .amc; empty: the one beside it
  std::optional<NamedSettings> settings;  // unset: never tuned
  ReadOptions reading = {};               // of its import options
};

}  // namespace mocapress
