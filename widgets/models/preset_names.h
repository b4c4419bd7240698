// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/batch/preset.h"

namespace mocapress {

/// What people read: the built-in ones in their language, their own as they called them.
QString displayName(const Preset& preset);

/// What a built-in preset is for; empty for any other.
QString purposeOf(const Preset& preset);

}  // namespace mocapress
