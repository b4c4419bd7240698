// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/studio/document/document.h"
#include "core/batch/preset.h"

namespace mocapress {

/// What a clip begins with where nothing else is known of it: "Gameplay".
const Preset& usualPreset();
ClipSettings usualSettings(const Skeleton& skeleton = {});

/// The settings by names, so that other clips can take them. Edited contacts are left out.
Preset presetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// With the edited contacts: for this clip alone.
Preset ownPresetOf(const ClipSettings& settings, const Skeleton& skeleton);

/// The settings as a preset has them; contacts stay. Throws Error where it names a joint that the
/// skeleton lacks.
ClipSettings withPreset(const ClipSettings& settings, const Preset& preset,
                        const Skeleton& skeleton);

/// Whether the preset would change nothing.
bool isAsPreset(const ClipSettings& settings, const Preset& preset, const Skeleton& skeleton);

/// Whether clips can be tuned by it, and not only measured: wavelets, by a target of the studio.
bool isTunable(const Preset& preset);

}  // namespace mocapress
