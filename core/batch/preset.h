// SPDX-License-Identifier: MIT
// A preset is settings with a name. These names are the studio's, until it says Settings too.
#pragma once

#include "core/mocapress/encode_options.h"
#include "core/mocapress/settings.h"

namespace mocapress {

using Preset = Settings;
using PresetCorrection = CorrectionSettings;
using PresetContact = ContactSetting;

}  // namespace mocapress
