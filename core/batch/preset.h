// SPDX-License-Identifier: MIT
// A preset is settings with a name. These names are the studio's, until it says Settings too.
#pragma once

#include "core/mocapress/encode_options.h"
#include "core/mocapress/settings.h"

namespace mocapress {
// In a namespace of their own, for one of the studio's enums has an enumerator of the same name,
// which GCC would say shadows this.
inline namespace names_of_presets {

using Preset = Settings;
using PresetCorrection = CorrectionSettings;
using PresetContact = ContactSetting;

}  // namespace names_of_presets
}  // namespace mocapress
